<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>Proves out three-axis milling programs before they touch metal.</source>
        <translation>Fährt dreiachsige Fräsprogramme ein, bevor sie Metall berühren.</translation>
    </message>
    <message>
        <source>The displayed surface is decimated locally while it is cut, by the method of Lee and Lee.</source>
        <translation>Die angezeigte Oberfläche wird während des Fräsens lokal dezimiert, nach dem Verfahren von Lee und Lee.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. There is no warranty. Prove out every new program at the machine, too.</source>
        <translation>Freie Software unter der GNU General Public License, Version 3 oder später. Ohne Gewähr. Fahren Sie jedes neue Programm auch an der Maschine vorsichtig ein.</translation>
    </message>
    <message>
        <source>About Proveout</source>
        <translation>Über Proveout</translation>
    </message>
    <message>
        <source>Keys and Mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Left drag, or Alt+arrow keys</source>
        <translation>Linke Taste ziehen oder Alt+Pfeiltasten</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Middle drag, or Shift+left drag</source>
        <translation>Mittlere Taste ziehen oder Umschalt+linke Taste ziehen</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Go to the cutting block of a point</source>
        <translation>Zum Satz gehen, der eine Stelle gefräst hat</translation>
    </message>
    <message>
        <source>Ctrl+click, or G and click, or right-click</source>
        <translation>Strg+Klick, G und Klick oder Rechtsklick</translation>
    </message>
    <message>
        <source>Centre a point and orbit about it</source>
        <translation>Eine Stelle zentrieren und um sie drehen</translation>
    </message>
    <message>
        <source>Double-click with the middle button</source>
        <translation>Doppelklick mit der mittleren Taste</translation>
    </message>
    <message>
        <source>Magnify a detail</source>
        <translation>Ein Detail vergrößern</translation>
    </message>
    <message>
        <source>B and drag a box, or B and click</source>
        <translation>B und Ausschnitt aufziehen oder B und Klick</translation>
    </message>
</context>
<context>
    <name>Activity</name>
    <message>
        <source>Cutting</source>
        <translation>Fräsen</translation>
    </message>
    <message>
        <source>Air cut</source>
        <translation>Luftschnitt</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>Rapid through stock</source>
        <translation>Eilgang durch das Rohteil</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Not simulated yet</source>
        <translation>Noch nicht simuliert</translation>
    </message>
    <message>
        <source>Blocks %1 to %2, share of machine time:</source>
        <translation>Sätze %1 bis %2, Anteil an der Maschinenzeit:</translation>
    </message>
    <message>
        <source>Block %1: %2</source>
        <translation>Satz %1: %2</translation>
    </message>
    <message>
        <source>Simulated so far: cutting %1, air cut %2, rapid %3 of the time</source>
        <translation>Bisher simuliert: Fräsen %1, Luftschnitt %2, Eilgang %3 der Zeit</translation>
    </message>
</context>
<context>
    <name>AppearanceMenus</name>
    <message>
        <source>Same as &amp;System</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
</context>
<context>
    <name>BreakpointsPanel</name>
    <message>
        <source>Compare with &lt; &lt;= &gt; &gt;= == != and combine with &amp;&amp; || ! and parentheses. Values:</source>
        <translation>Vergleichen mit &lt; &lt;= &gt; &gt;= == !=, verknüpfen mit &amp;&amp; || ! und Klammern. Werte:</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Breakpoint type</source>
        <translation>Art des Haltepunkts</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Stop before this line
Range: 1 to %1
Default: 1</source>
        <translation>Vor dieser Zeile anhalten
Bereich: 1 bis %1
Vorgabe: 1</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Stop before a block that moves below this height
Range: %1 to %2 mm
Default: 0 mm</source>
        <translation>Vor einem Satz anhalten, der unter diese Höhe fährt
Bereich: %1 bis %2 mm
Vorgabe: 0 mm</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add this breakpoint; to add one in the editor, click a line number</source>
        <translation>Diesen Haltepunkt hinzufügen; im Editor auf eine Zeilennummer klicken, um dort einen zu setzen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected breakpoints</source>
        <translation>Die gewählten Haltepunkte entfernen</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>Haltepunkte</translation>
    </message>
    <message>
        <source>Stop at</source>
        <translation>Halt bei</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
</context>
<context>
    <name>CloserLook</name>
    <message>
        <source>Drag a box on the stock, or click a point.</source>
        <translation>Auf dem Rohteil einen Ausschnitt aufziehen oder eine Stelle anklicken.</translation>
    </message>
    <message>
        <source>At block %1: cutting…</source>
        <translation>Bei Satz %1: wird gefräst …</translation>
    </message>
    <message>
        <source>At block %1: %2 × %3 points, spacing %4 mm; %5 triangles, %6 s</source>
        <translation>Bei Satz %1: %2 × %3 Punkte im Abstand von %4 mm; %5 Dreiecke, %6 s</translation>
    </message>
    <message>
        <source>At block %1: cancelled.</source>
        <translation>Bei Satz %1: abgebrochen.</translation>
    </message>
</context>
<context>
    <name>CloserLookForm</name>
    <message>
        <source>Magnifier</source>
        <translation>Detaillupe</translation>
    </message>
    <message>
        <source>Box:</source>
        <translation>Ausschnitt:</translation>
    </message>
    <message>
        <source>Grid spacing:</source>
        <translation>Rasterweite:</translation>
    </message>
    <message>
        <source>Box size in X</source>
        <translation>Größe des Ausschnitts in X</translation>
    </message>
    <message>
        <source>Box size in Y</source>
        <translation>Größe des Ausschnitts in Y</translation>
    </message>
    <message>
        <source>Grid spacing in the box</source>
        <translation>Rasterweite im Ausschnitt</translation>
    </message>
    <message>
        <source>%1 From %2 to %3 mm. Default: %4 mm.</source>
        <translation>%1 Von %2 bis %3 mm. Vorgabe: %4 mm.</translation>
    </message>
    <message>
        <source>Size of the box in X; a click makes a box of this size.</source>
        <translation>Größe des Ausschnitts in X; ein Klick setzt einen Ausschnitt dieser Größe.</translation>
    </message>
    <message>
        <source>Size of the box in Y; a click makes a box of this size.</source>
        <translation>Größe des Ausschnitts in Y; ein Klick setzt einen Ausschnitt dieser Größe.</translation>
    </message>
    <message>
        <source>Distance between the grid points in the box.</source>
        <translation>Abstand der Rasterpunkte im Ausschnitt.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel this task</source>
        <translation>Diesen Vorgang abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>Cut Again</source>
        <translation>Noch einmal fräsen</translation>
    </message>
    <message>
        <source>Cut the cancelled box again</source>
        <translation>Den abgebrochenen Ausschnitt noch einmal fräsen</translation>
    </message>
</context>
<context>
    <name>CompareDialog</name>
    <message>
        <source>in this window</source>
        <translation>in diesem Fenster</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Differences of %1</source>
        <translation>Unterschiede von %1</translation>
    </message>
    <message>
        <source>Both versions of %1 have the same lines.</source>
        <translation>Beide Fassungen von %1 haben dieselben Zeilen.</translation>
    </message>
    <message>
        <source>− lines only on disk: %1</source>
        <translation>− Zeilen nur auf dem Datenträger: %1</translation>
    </message>
    <message>
        <source>+ lines only %1: %2</source>
        <translation>+ Zeilen nur %1: %2</translation>
    </message>
    <message>
        <source>&amp;Previous Difference</source>
        <translation>&amp;Vorheriger Unterschied</translation>
    </message>
    <message>
        <source>&amp;Next Difference</source>
        <translation>&amp;Nächster Unterschied</translation>
    </message>
    <message>
        <source>Only the first %1 lines are shown.</source>
        <translation>Nur die ersten %1 Zeilen werden gezeigt.</translation>
    </message>
</context>
<context>
    <name>ControlForm</name>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Automatic: none of these</source>
        <translation>Automatisch: keiner davon</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>Automatisch: %1</translation>
    </message>
</context>
<context>
    <name>ControlPanel</name>
    <message>
        <source>Control state</source>
        <translation>Zustand der Steuerung</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Open a program to see the modal codes, offsets and variables at the current block.</source>
        <translation>Öffnen Sie ein Programm, um die modalen Befehle, Korrekturen und Variablen am aktuellen Satz zu sehen.</translation>
    </message>
    <message>
        <source>Calls</source>
        <translation>Aufrufe</translation>
    </message>
    <message>
        <source>from line %1</source>
        <translation>aus Zeile %1</translation>
    </message>
    <message>
        <source>Modal codes</source>
        <translation>Modale Befehle</translation>
    </message>
    <message>
        <source>Position and offsets (mm)</source>
        <translation>Position und Korrekturen (mm)</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variablen</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>The file cannot be read: {}.</source>
        <translation>Die Datei lässt sich nicht lesen: {}.</translation>
    </message>
    <message>
        <source>The file cannot be written ({} needed): {}.</source>
        <translation>Die Datei lässt sich nicht schreiben ({} nötig): {}.</translation>
    </message>
    <message>
        <source>This is not a regular file.</source>
        <translation>Das ist keine gewöhnliche Datei.</translation>
    </message>
    <message>
        <source>The file has {}; the limit is {}.</source>
        <translation>Die Datei ist {} groß; zulässig sind {}.</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Included angle</source>
        <translation>Spitzenwinkel</translation>
    </message>
    <message>
        <source>Diameter of the flat tip</source>
        <translation>Durchmesser der flachen Spitze</translation>
    </message>
    <message>
        <source>Flute length</source>
        <translation>Schneidenlänge</translation>
    </message>
    <message>
        <source>Shank diameter (0: as the cutter)</source>
        <translation>Schaftdurchmesser (0: wie der Fräser)</translation>
    </message>
    <message>
        <source>Shank length</source>
        <translation>Schaftlänge</translation>
    </message>
    <message>
        <source>Flat end mill</source>
        <translation>Schaftfräser</translation>
    </message>
    <message>
        <source>Ball-end mill</source>
        <translation>Kugelfräser</translation>
    </message>
    <message>
        <source>Bull-nose mill</source>
        <translation>Torusfräser</translation>
    </message>
    <message>
        <source>Cone or V cutter</source>
        <translation>Kegel- oder V-Fräser</translation>
    </message>
    <message>
        <source>Tool {} is in the table twice.</source>
        <translation>Werkzeug {} steht zweimal in der Tabelle.</translation>
    </message>
    <message>
        <source>Tool {} needs a cutter, e.g. cutter = &quot;ball:d=11,l=50&quot;.</source>
        <translation>Werkzeug {} braucht einen Fräser, z. B. cutter = &quot;ball:d=11,l=50&quot;.</translation>
    </message>
    <message>
        <source>The file holds no [[tool]] tables.</source>
        <translation>Die Datei enthält keine Tabellen [[tool]].</translation>
    </message>
    <message>
        <source>A tool must be a table: [[tool]].</source>
        <translation>Ein Werkzeug muss eine Tabelle sein: [[tool]].</translation>
    </message>
    <message>
        <source>The tool table cannot be read: {}.</source>
        <translation>Die Werkzeugtabelle lässt sich nicht lesen: {}.</translation>
    </message>
    <message>
        <source>Lee &amp; Lee (local)</source>
        <translation>Lee &amp; Lee (lokal)</translation>
    </message>
    <message>
        <source>Global</source>
        <translation>Global</translation>
    </message>
    <message>
        <source>None (full mesh)</source>
        <translation>Keine (volles Netz)</translation>
    </message>
    <message>
        <source>Shared, no cracks</source>
        <translation>Gemeinsam, ohne Risse</translation>
    </message>
    <message>
        <source>Per region, as in the paper</source>
        <translation>Je Region, wie im Aufsatz</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufällig</translation>
    </message>
    <message>
        <source>Sequential</source>
        <translation>Der Reihe nach</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How the mesh of a region is decimated.</source>
        <translation>Wie das Netz einer Region dezimiert wird.</translation>
    </message>
    <message>
        <source>Region size</source>
        <translation>Regionsgröße</translation>
    </message>
    <message>
        <source>Cells along each side of a region; each region has its own mesh.</source>
        <translation>Zellen je Seite einer Region; jede Region hat ihr eigenes Netz.</translation>
    </message>
    <message>
        <source>Decimation period</source>
        <translation>Dezimierungsperiode</translation>
    </message>
    <message>
        <source>Cut regions are decimated again after this many blocks; -1: once at the start, 0: never.</source>
        <translation>Gefräste Regionen werden nach so vielen Sätzen neu dezimiert; -1: einmal zu Beginn, 0: nie.</translation>
    </message>
    <message>
        <source>Error allowance</source>
        <translation>Zulässiger Fehler</translation>
    </message>
    <message>
        <source>Largest vertical error of the decimated surface; 0: no decimation.</source>
        <translation>Größter senkrechter Fehler der dezimierten Fläche; 0: keine Dezimierung.</translation>
    </message>
    <message>
        <source>Certify</source>
        <translation>Zertifizieren</translation>
    </message>
    <message>
        <source>Keep every z-map point within the error allowance; off: exactly as in the paper, which gives no bound.</source>
        <translation>Hält jeden Punkt der Z-Map innerhalb des zulässigen Fehlers; aus: genau wie im Aufsatz, der keine Schranke angibt.</translation>
    </message>
    <message>
        <source>Borders</source>
        <translation>Ränder</translation>
    </message>
    <message>
        <source>How the borders between regions are simplified.</source>
        <translation>Wie die Ränder zwischen den Regionen vereinfacht werden.</translation>
    </message>
    <message>
        <source>Removal order</source>
        <translation>Reihenfolge des Entfernens</translation>
    </message>
    <message>
        <source>The order in which vertices are tested for removal.</source>
        <translation>Die Reihenfolge, in der Eckpunkte auf Entfernbarkeit geprüft werden.</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Start of the random order; equal seeds give equal meshes.</source>
        <translation>Beginn der Zufallsfolge; gleiche Startwerte ergeben gleiche Netze.</translation>
    </message>
    <message>
        <source>STL, binary</source>
        <translation>STL, binär</translation>
    </message>
    <message>
        <source>a closed triangle mesh of the stock</source>
        <translation>ein geschlossenes Dreiecksnetz des Rohteils</translation>
    </message>
    <message>
        <source>STL, ASCII</source>
        <translation>STL, ASCII</translation>
    </message>
    <message>
        <source>NumPy array</source>
        <translation>NumPy-Feld</translation>
    </message>
    <message>
        <source>the heights of a z-map, row 0 at the smallest y</source>
        <translation>die Höhen einer Z-Map, Zeile 0 beim kleinsten y</translation>
    </message>
    <message>
        <source>Proveout job</source>
        <translation>Proveout-Auftrag</translation>
    </message>
    <message>
        <source>a program with its stock, tools and parameters</source>
        <translation>ein Programm mit Rohteil, Werkzeugen und Parametern</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; is not a cutter: {}</source>
        <translation>Das Feld „{}“ ist kein Fräser: {}</translation>
    </message>
    <message>
        <source>This is not a Proveout job: the field &quot;proveout&quot; with the number of its format is missing.</source>
        <translation>Das ist kein Proveout-Auftrag: Das Feld „proveout“ mit der Nummer des Formats fehlt.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be the number of the format.</source>
        <translation>Das Feld „{}“ muss die Nummer des Formats sein.</translation>
    </message>
    <message>
        <source>The job was written by a newer Proveout (format {}); this one reads up to format {}.</source>
        <translation>Der Auftrag stammt von einem neueren Proveout (Format {}); dieses liest bis Format {}.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; names {}, which is outside the folder of the job; it was not read.</source>
        <translation>Das Feld „{}“ nennt {}; das liegt außerhalb des Auftragsordners und wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must name a file.</source>
        <translation>Das Feld „{}“ muss eine Datei nennen.</translation>
    </message>
    <message>
        <source>The name of the program is not UTF-8, which JSON needs; rename it.</source>
        <translation>Der Name des Programms ist nicht in UTF-8, wie JSON es verlangt; umbenennen.</translation>
    </message>
    <message>
        <source>The brackets are nested deeper than {} levels.</source>
        <translation>Die Klammern sind tiefer als {} Ebenen geschachtelt.</translation>
    </message>
    <message>
        <source>This is not valid JSON.</source>
        <translation>Das ist kein gültiges JSON.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; is missing.</source>
        <translation>Das Feld „{}“ fehlt.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be a number above {} and at most {}.</source>
        <translation>Das Feld „{}“ muss eine Zahl über {} und höchstens {} sein.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be a number from {} to {}.</source>
        <translation>Das Feld „{}“ muss eine Zahl von {} bis {} sein.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be a text.</source>
        <translation>Das Feld „{}“ muss ein Text sein.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be a whole number.</source>
        <translation>Das Feld „{}“ muss eine ganze Zahl sein.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be true or false.</source>
        <translation>Das Feld „{}“ muss true oder false sein.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be three numbers [x, y, z].</source>
        <translation>Das Feld „{}“ muss aus drei Zahlen [x, y, z] bestehen.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be one of {}.</source>
        <translation>Das Feld „{}“ muss einer dieser Werte sein: {}.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be an object { }.</source>
        <translation>Das Feld „{}“ muss ein Objekt { } sein.</translation>
    </message>
    <message>
        <source>The NPY file holds values of type &quot;{}&quot;; little-endian float32 (&quot;&lt;f4&quot;) or float64 (&quot;&lt;f8&quot;) is needed.</source>
        <translation>Die NPY-Datei enthält Werte vom Typ „{}“; nötig ist float32 („&lt;f4“) oder float64 („&lt;f8“), little-endian.</translation>
    </message>
    <message>
        <source>The NPY file is in Fortran order; C order is needed.</source>
        <translation>Die NPY-Datei ist in Fortran-Reihenfolge; nötig ist C-Reihenfolge.</translation>
    </message>
    <message>
        <source>The NPY file has the shape {}; two dimensions (rows, columns) are needed.</source>
        <translation>Die NPY-Datei hat die Form {}; nötig sind zwei Dimensionen (Zeilen, Spalten).</translation>
    </message>
    <message>
        <source>The header of the NPY file specifies {} values ({}), but only {} are in the file.</source>
        <translation>Der Kopf der NPY-Datei gibt {} Werte an ({}), in der Datei sind aber nur {}.</translation>
    </message>
    <message>
        <source>The NPY file has the shape {}; that is too large.</source>
        <translation>Die NPY-Datei hat die Form {}; das ist zu groß.</translation>
    </message>
    <message>
        <source>The value in row {}, column {} (counted from 0) is {}; heights must be finite and fit float32.</source>
        <translation>Der Wert in Zeile {}, Spalte {} (ab 0 gezählt) ist {}; Höhen müssen endlich sein und in float32 passen.</translation>
    </message>
    <message>
        <source>The header of the NPY file cannot be read at byte {}.</source>
        <translation>Der Kopf der NPY-Datei ist bei Byte {} nicht lesbar.</translation>
    </message>
    <message>
        <source>This is not an NPY file.</source>
        <translation>Das ist keine NPY-Datei.</translation>
    </message>
    <message>
        <source>The NPY file has format version {}; versions 1 to 3 are known.</source>
        <translation>Die NPY-Datei hat die Formatversion {}; bekannt sind 1 bis 3.</translation>
    </message>
    <message>
        <source>The NPY file ends at byte {}, within its header of {} bytes.</source>
        <translation>Die NPY-Datei endet bei Byte {}, innerhalb ihres Kopfes von {} Bytes.</translation>
    </message>
    <message>
        <source>Expected &quot;{}&quot; but the file ends.</source>
        <translation>„{}“ erwartet, aber die Datei endet.</translation>
    </message>
    <message>
        <source>Expected &quot;{2}&quot; but found &quot;{1}&quot;.</source>
        <translation>„{2}“ erwartet, aber „{1}“ gefunden.</translation>
    </message>
    <message>
        <source>The file ends without &quot;endsolid&quot;; it may have been cut off.</source>
        <translation>Die Datei endet ohne „endsolid“; vielleicht wurde sie abgeschnitten.</translation>
    </message>
    <message>
        <source>The header specifies {} facets, but the file ends at byte {}, after {}.</source>
        <translation>Der Kopf gibt {} Facetten an, die Datei endet aber bei Byte {}, nach {}.</translation>
    </message>
    <message>
        <source>The {} facets specified in the header were read; {} bytes follow them from byte {}.</source>
        <translation>Die {} im Kopf angegebenen Facetten wurden gelesen; ab Byte {3} folgen noch {2} Bytes.</translation>
    </message>
    <message>
        <source>This is not an STL file.</source>
        <translation>Das ist keine STL-Datei.</translation>
    </message>
    <message>
        <source>This is not an STL file: it ends at byte {}, within the header.</source>
        <translation>Das ist keine STL-Datei: Sie endet bei Byte {}, innerhalb des Kopfes.</translation>
    </message>
    <message>
        <source>{} of {} facets have a coordinate that is not a finite number; they were ignored.</source>
        <translation>{} von {} Facetten haben eine Koordinate, die keine endliche Zahl ist; sie wurden ignoriert.</translation>
    </message>
    <message>
        <source>{} of {} facets have no area; they were ignored.</source>
        <translation>{} von {} Facetten haben keine Fläche; sie wurden ignoriert.</translation>
    </message>
    <message>
        <source>{} of {} facets have a normal against their winding; the winding counts.</source>
        <translation>Bei {} von {} Facetten widerspricht die Normale dem Umlaufsinn; es gilt der Umlaufsinn.</translation>
    </message>
    <message>
        <source>The mesh is {} mm from the origin, where an STL file resolves steps of {} mm only.</source>
        <translation>Das Netz liegt {} mm vom Ursprung entfernt; dort löst eine STL-Datei nur noch Schritte von {} mm auf.</translation>
    </message>
    <message>
        <source>The mesh is {} × {} × {} mm: hardly a part.</source>
        <translation>Das Netz misst {} × {} × {} mm: kaum ein Werkstück.</translation>
    </message>
    <message>
        <source>The file holds no facet that could be used ({} read, {} not finite, {} without area).</source>
        <translation>Die Datei enthält keine brauchbare Facette ({} gelesen, {} nicht endlich, {} ohne Fläche).</translation>
    </message>
    <message>
        <source>The mesh has {} triangles; an STL file holds 4294967295.</source>
        <translation>Das Netz hat {} Dreiecke; eine STL-Datei fasst höchstens 4294967295.</translation>
    </message>
    <message>
        <source>Cancelled; no file was written.</source>
        <translation>Abgebrochen; es wurde keine Datei geschrieben.</translation>
    </message>
    <message>
        <source>rapid motion</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>straight feed</source>
        <translation>Gerade im Vorschub</translation>
    </message>
    <message>
        <source>clockwise arc</source>
        <translation>Kreisbogen im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>counter-clockwise arc</source>
        <translation>Kreisbogen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>Verweilzeit</translation>
    </message>
    <message>
        <source>cubic spline</source>
        <translation>kubischer Spline</translation>
    </message>
    <message>
        <source>quadratic spline</source>
        <translation>quadratischer Spline</translation>
    </message>
    <message>
        <source>NURBS block</source>
        <translation>NURBS-Block</translation>
    </message>
    <message>
        <source>end of NURBS block</source>
        <translation>Ende des NURBS-Blocks</translation>
    </message>
    <message>
        <source>lathe diameter mode</source>
        <translation>Durchmesserprogrammierung (Drehen)</translation>
    </message>
    <message>
        <source>lathe radius mode</source>
        <translation>Radiusprogrammierung (Drehen)</translation>
    </message>
    <message>
        <source>exact stop in one block</source>
        <translation>Genauhalt in einem Satz</translation>
    </message>
    <message>
        <source>set offsets</source>
        <translation>Korrekturen setzen</translation>
    </message>
    <message>
        <source>clockwise circular pocket</source>
        <translation>Kreistasche im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>counter-clockwise circular pocket</source>
        <translation>Kreistasche gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>polar coordinates off</source>
        <translation>Polarkoordinaten aus</translation>
    </message>
    <message>
        <source>polar coordinates on</source>
        <translation>Polarkoordinaten ein</translation>
    </message>
    <message>
        <source>XY plane</source>
        <translation>XY-Ebene</translation>
    </message>
    <message>
        <source>UV plane</source>
        <translation>UV-Ebene</translation>
    </message>
    <message>
        <source>ZX plane</source>
        <translation>ZX-Ebene</translation>
    </message>
    <message>
        <source>WU plane</source>
        <translation>WU-Ebene</translation>
    </message>
    <message>
        <source>YZ plane</source>
        <translation>YZ-Ebene</translation>
    </message>
    <message>
        <source>VW plane</source>
        <translation>VW-Ebene</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>move to reference position</source>
        <translation>Referenzpunkt anfahren</translation>
    </message>
    <message>
        <source>store reference position</source>
        <translation>Referenzpunkt speichern</translation>
    </message>
    <message>
        <source>move to second reference position</source>
        <translation>zweiten Referenzpunkt anfahren</translation>
    </message>
    <message>
        <source>store second reference position</source>
        <translation>zweiten Referenzpunkt speichern</translation>
    </message>
    <message>
        <source>skip motion (probe)</source>
        <translation>Bewegung mit Restweglöschen (Messen)</translation>
    </message>
    <message>
        <source>spindle-synchronised motion</source>
        <translation>spindelsynchrone Bewegung</translation>
    </message>
    <message>
        <source>rigid tapping</source>
        <translation>Gewindebohren ohne Ausgleichsfutter</translation>
    </message>
    <message>
        <source>probe toward the part, error on failure</source>
        <translation>Antasten zum Werkstück hin, Fehler ohne Kontakt</translation>
    </message>
    <message>
        <source>probe toward the part</source>
        <translation>Antasten zum Werkstück hin</translation>
    </message>
    <message>
        <source>probe away from the part, error on failure</source>
        <translation>Antasten vom Werkstück weg, Fehler ohne Lösen</translation>
    </message>
    <message>
        <source>probe away from the part</source>
        <translation>Antasten vom Werkstück weg</translation>
    </message>
    <message>
        <source>cutter compensation off</source>
        <translation>Fräserradiuskorrektur aus</translation>
    </message>
    <message>
        <source>cutter compensation left</source>
        <translation>Fräserradiuskorrektur links</translation>
    </message>
    <message>
        <source>dynamic cutter compensation left</source>
        <translation>Fräserradiuskorrektur links, Durchmesser im Satz</translation>
    </message>
    <message>
        <source>cutter compensation right</source>
        <translation>Fräserradiuskorrektur rechts</translation>
    </message>
    <message>
        <source>dynamic cutter compensation right</source>
        <translation>Fräserradiuskorrektur rechts, Durchmesser im Satz</translation>
    </message>
    <message>
        <source>tool length offset</source>
        <translation>Werkzeuglängenkorrektur</translation>
    </message>
    <message>
        <source>dynamic tool length offset</source>
        <translation>Werkzeuglängenkorrektur, Werte im Satz</translation>
    </message>
    <message>
        <source>additional tool length offset</source>
        <translation>zusätzliche Werkzeuglängenkorrektur</translation>
    </message>
    <message>
        <source>negative tool length offset</source>
        <translation>negative Werkzeuglängenkorrektur</translation>
    </message>
    <message>
        <source>tool length offset off</source>
        <translation>Werkzeuglängenkorrektur aus</translation>
    </message>
    <message>
        <source>scaling off</source>
        <translation>Skalierung aus</translation>
    </message>
    <message>
        <source>mirroring off</source>
        <translation>Spiegelung aus</translation>
    </message>
    <message>
        <source>scaling</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>mirroring</source>
        <translation>Spiegelung</translation>
    </message>
    <message>
        <source>local coordinate shift</source>
        <translation>lokale Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>machine coordinates</source>
        <translation>Maschinenkoordinaten</translation>
    </message>
    <message>
        <source>work offset 1</source>
        <translation>Nullpunktverschiebung 1</translation>
    </message>
    <message>
        <source>additional work offset</source>
        <translation>zusätzliche Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>work offset 2</source>
        <translation>Nullpunktverschiebung 2</translation>
    </message>
    <message>
        <source>work offset 3</source>
        <translation>Nullpunktverschiebung 3</translation>
    </message>
    <message>
        <source>work offset 4</source>
        <translation>Nullpunktverschiebung 4</translation>
    </message>
    <message>
        <source>work offset 5</source>
        <translation>Nullpunktverschiebung 5</translation>
    </message>
    <message>
        <source>work offset 6</source>
        <translation>Nullpunktverschiebung 6</translation>
    </message>
    <message>
        <source>work offset 7</source>
        <translation>Nullpunktverschiebung 7</translation>
    </message>
    <message>
        <source>work offset 8</source>
        <translation>Nullpunktverschiebung 8</translation>
    </message>
    <message>
        <source>work offset 9</source>
        <translation>Nullpunktverschiebung 9</translation>
    </message>
    <message>
        <source>exact path</source>
        <translation>exakte Bahn</translation>
    </message>
    <message>
        <source>exact stop</source>
        <translation>Genauhalt</translation>
    </message>
    <message>
        <source>path blending</source>
        <translation>Überschleifen</translation>
    </message>
    <message>
        <source>macro call</source>
        <translation>Makroaufruf</translation>
    </message>
    <message>
        <source>modal macro call</source>
        <translation>modaler Makroaufruf</translation>
    </message>
    <message>
        <source>modal macro call off</source>
        <translation>modaler Makroaufruf aus</translation>
    </message>
    <message>
        <source>coordinate rotation</source>
        <translation>Koordinatendrehung</translation>
    </message>
    <message>
        <source>coordinate rotation off</source>
        <translation>Koordinatendrehung aus</translation>
    </message>
    <message>
        <source>finishing cycle or bolt circle</source>
        <translation>Schlichtzyklus oder Lochkreis</translation>
    </message>
    <message>
        <source>roughing cycle or bolt arc</source>
        <translation>Schruppzyklus oder Lochbogen</translation>
    </message>
    <message>
        <source>facing cycle or bolt line</source>
        <translation>Planzyklus oder Lochreihe</translation>
    </message>
    <message>
        <source>chip-breaking drilling cycle</source>
        <translation>Bohrzyklus mit Spanbruch</translation>
    </message>
    <message>
        <source>left-hand tapping cycle</source>
        <translation>Gewindebohrzyklus, Linksgewinde</translation>
    </message>
    <message>
        <source>threading or fine boring cycle</source>
        <translation>Gewinde- oder Feinbohrzyklus</translation>
    </message>
    <message>
        <source>motion mode off</source>
        <translation>Bewegungsart aus</translation>
    </message>
    <message>
        <source>drilling cycle</source>
        <translation>Bohrzyklus</translation>
    </message>
    <message>
        <source>drilling cycle with dwell</source>
        <translation>Bohrzyklus mit Verweilzeit</translation>
    </message>
    <message>
        <source>deep-hole drilling cycle</source>
        <translation>Tieflochbohrzyklus</translation>
    </message>
    <message>
        <source>right-hand tapping cycle</source>
        <translation>Gewindebohrzyklus, Rechtsgewinde</translation>
    </message>
    <message>
        <source>boring cycle, feed out</source>
        <translation>Ausdrehzyklus, Rückzug im Vorschub</translation>
    </message>
    <message>
        <source>boring cycle, stop and rapid out</source>
        <translation>Ausdrehzyklus, Halt und Rückzug im Eilgang</translation>
    </message>
    <message>
        <source>back boring cycle</source>
        <translation>Rückwärtssenkzyklus</translation>
    </message>
    <message>
        <source>boring cycle, manual out</source>
        <translation>Ausdrehzyklus, Rückzug von Hand</translation>
    </message>
    <message>
        <source>boring cycle with dwell</source>
        <translation>Ausdrehzyklus mit Verweilzeit</translation>
    </message>
    <message>
        <source>absolute distances</source>
        <translation>absolute Maßangabe</translation>
    </message>
    <message>
        <source>absolute arc centres</source>
        <translation>absolute Kreismittelpunkte</translation>
    </message>
    <message>
        <source>incremental distances</source>
        <translation>inkrementale Maßangabe</translation>
    </message>
    <message>
        <source>incremental arc centres</source>
        <translation>inkrementale Kreismittelpunkte</translation>
    </message>
    <message>
        <source>coordinate shift</source>
        <translation>Koordinatenverschiebung</translation>
    </message>
    <message>
        <source>coordinate shift off, cleared</source>
        <translation>Koordinatenverschiebung aus und gelöscht</translation>
    </message>
    <message>
        <source>coordinate shift off</source>
        <translation>Koordinatenverschiebung aus</translation>
    </message>
    <message>
        <source>coordinate shift restored</source>
        <translation>Koordinatenverschiebung wieder ein</translation>
    </message>
    <message>
        <source>inverse time feed</source>
        <translation>zeitreziproker Vorschub</translation>
    </message>
    <message>
        <source>feed per minute</source>
        <translation>Vorschub je Minute</translation>
    </message>
    <message>
        <source>feed per revolution</source>
        <translation>Vorschub je Umdrehung</translation>
    </message>
    <message>
        <source>constant surface speed</source>
        <translation>konstante Schnittgeschwindigkeit</translation>
    </message>
    <message>
        <source>constant spindle speed</source>
        <translation>konstante Drehzahl</translation>
    </message>
    <message>
        <source>cycles retract to the initial level</source>
        <translation>Zyklen fahren auf die Ausgangsebene zurück</translation>
    </message>
    <message>
        <source>cycles retract to the R plane</source>
        <translation>Zyklen fahren auf die R-Ebene zurück</translation>
    </message>
    <message>
        <source>program stop</source>
        <translation>Programmhalt</translation>
    </message>
    <message>
        <source>optional stop</source>
        <translation>wahlweiser Halt</translation>
    </message>
    <message>
        <source>end of program</source>
        <translation>Programmende</translation>
    </message>
    <message>
        <source>spindle clockwise</source>
        <translation>Spindel im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>spindle counter-clockwise</source>
        <translation>Spindel gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>spindle stop</source>
        <translation>Spindelhalt</translation>
    </message>
    <message>
        <source>tool change</source>
        <translation>Werkzeugwechsel</translation>
    </message>
    <message>
        <source>mist coolant on</source>
        <translation>Sprühkühlung ein</translation>
    </message>
    <message>
        <source>flood coolant on</source>
        <translation>Kühlmittel ein</translation>
    </message>
    <message>
        <source>coolant off</source>
        <translation>Kühlmittel aus</translation>
    </message>
    <message>
        <source>spindle orientation</source>
        <translation>Spindelorientierung</translation>
    </message>
    <message>
        <source>end of program, rewind</source>
        <translation>Programmende mit Rücksprung</translation>
    </message>
    <message>
        <source>overrides on</source>
        <translation>Override ein</translation>
    </message>
    <message>
        <source>overrides off</source>
        <translation>Override aus</translation>
    </message>
    <message>
        <source>feed override</source>
        <translation>Vorschub-Override</translation>
    </message>
    <message>
        <source>spindle override</source>
        <translation>Spindel-Override</translation>
    </message>
    <message>
        <source>adaptive feed</source>
        <translation>adaptiver Vorschub</translation>
    </message>
    <message>
        <source>feed stop</source>
        <translation>Vorschubhalt</translation>
    </message>
    <message>
        <source>pallet change</source>
        <translation>Palettenwechsel</translation>
    </message>
    <message>
        <source>set the tool number</source>
        <translation>Werkzeugnummer setzen</translation>
    </message>
    <message>
        <source>digital output on, synchronised</source>
        <translation>Digitalausgang ein, bahnsynchron</translation>
    </message>
    <message>
        <source>digital output off, synchronised</source>
        <translation>Digitalausgang aus, bahnsynchron</translation>
    </message>
    <message>
        <source>digital output on</source>
        <translation>Digitalausgang ein</translation>
    </message>
    <message>
        <source>digital output off</source>
        <translation>Digitalausgang aus</translation>
    </message>
    <message>
        <source>wait for an input</source>
        <translation>auf einen Eingang warten</translation>
    </message>
    <message>
        <source>analog output, synchronised</source>
        <translation>Analogausgang, bahnsynchron</translation>
    </message>
    <message>
        <source>analog output</source>
        <translation>Analogausgang</translation>
    </message>
    <message>
        <source>save modal state</source>
        <translation>modalen Zustand sichern</translation>
    </message>
    <message>
        <source>discard modal state</source>
        <translation>modalen Zustand verwerfen</translation>
    </message>
    <message>
        <source>restore modal state</source>
        <translation>modalen Zustand wiederherstellen</translation>
    </message>
    <message>
        <source>save modal state, restored at the end</source>
        <translation>modalen Zustand sichern, am Ende wiederherstellen</translation>
    </message>
    <message>
        <source>local subprogram call</source>
        <translation>Aufruf eines lokalen Unterprogramms</translation>
    </message>
    <message>
        <source>subprogram call</source>
        <translation>Unterprogrammaufruf</translation>
    </message>
    <message>
        <source>end of subprogram</source>
        <translation>Ende des Unterprogramms</translation>
    </message>
    <message>
        <source>rotary axis about X</source>
        <translation>Drehachse um X</translation>
    </message>
    <message>
        <source>rotary axis about Y</source>
        <translation>Drehachse um Y</translation>
    </message>
    <message>
        <source>rotary axis about Z</source>
        <translation>Drehachse um Z</translation>
    </message>
    <message>
        <source>cutter compensation number</source>
        <translation>Nummer der Fräserradiuskorrektur</translation>
    </message>
    <message>
        <source>parameter of a code</source>
        <translation>Parameter eines Befehls</translation>
    </message>
    <message>
        <source>feed rate</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>tool length offset number</source>
        <translation>Nummer der Werkzeuglängenkorrektur</translation>
    </message>
    <message>
        <source>arc centre in X</source>
        <translation>Kreismittelpunkt in X</translation>
    </message>
    <message>
        <source>arc centre in Y</source>
        <translation>Kreismittelpunkt in Y</translation>
    </message>
    <message>
        <source>arc centre in Z</source>
        <translation>Kreismittelpunkt in Z</translation>
    </message>
    <message>
        <source>repeats</source>
        <translation>Wiederholungen</translation>
    </message>
    <message>
        <source>block number</source>
        <translation>Satznummer</translation>
    </message>
    <message>
        <source>program number</source>
        <translation>Programmnummer</translation>
    </message>
    <message>
        <source>dwell in seconds, turns of an arc, or a parameter</source>
        <translation>Verweilzeit in Sekunden, Umläufe eines Kreisbogens oder ein Parameter</translation>
    </message>
    <message>
        <source>arc radius, or the R plane</source>
        <translation>Radius des Kreisbogens oder R-Ebene</translation>
    </message>
    <message>
        <source>spindle speed in revolutions per minute</source>
        <translation>Spindeldrehzahl in Umdrehungen je Minute</translation>
    </message>
    <message>
        <source>tool number</source>
        <translation>Werkzeugnummer</translation>
    </message>
    <message>
        <source>second axis along X</source>
        <translation>zweite Achse längs X</translation>
    </message>
    <message>
        <source>second axis along Y</source>
        <translation>zweite Achse längs Y</translation>
    </message>
    <message>
        <source>second axis along Z</source>
        <translation>zweite Achse längs Z</translation>
    </message>
    <message>
        <source>X coordinate</source>
        <translation>X-Koordinate</translation>
    </message>
    <message>
        <source>Y coordinate</source>
        <translation>Y-Koordinate</translation>
    </message>
    <message>
        <source>Z coordinate</source>
        <translation>Z-Koordinate</translation>
    </message>
    <message>
        <source>Remove the character, or put the text into a comment: ( … ).</source>
        <translation>Das Zeichen entfernen oder den Text in einen Kommentar setzen: ( … ).</translation>
    </message>
    <message>
        <source>Write the value after the letter, for example X10.5.</source>
        <translation>Den Wert nach dem Buchstaben schreiben, zum Beispiel X10.5.</translation>
    </message>
    <message>
        <source>Controls read this differently; write one sign.</source>
        <translation>Steuerungen lesen das verschieden; nur ein Vorzeichen schreiben.</translation>
    </message>
    <message>
        <source>Keep one point.</source>
        <translation>Nur einen Punkt stehen lassen.</translation>
    </message>
    <message>
        <source>Check the number.</source>
        <translation>Die Zahl prüfen.</translation>
    </message>
    <message>
        <source>Close it with &quot;)&quot; in the same line.</source>
        <translation>In derselben Zeile mit „)“ schließen.</translation>
    </message>
    <message>
        <source>Controls end it at different brackets; use no &quot;(&quot; within a comment.</source>
        <translation>Steuerungen beenden ihn an verschiedenen Klammern; kein „(“ in einem Kommentar verwenden.</translation>
    </message>
    <message>
        <source>Keep one of them, or make two blocks.</source>
        <translation>Nur eines davon behalten oder auf zwei Sätze aufteilen.</translation>
    </message>
    <message>
        <source>Make several blocks of it.</source>
        <translation>Auf mehrere Sätze aufteilen.</translation>
    </message>
    <message>
        <source>Write it first, or put it on a line of its own.</source>
        <translation>An den Satzanfang oder in eine eigene Zeile schreiben.</translation>
    </message>
    <message>
        <source>Use N with digits only.</source>
        <translation>N nur mit Ziffern verwenden.</translation>
    </message>
    <message>
        <source>Move the rest to another line.</source>
        <translation>Den Rest in eine andere Zeile schreiben.</translation>
    </message>
    <message>
        <source>LinuxCNC refuses this; write &quot;%&quot; on the first line too, or on none.</source>
        <translation>LinuxCNC lehnt das ab; „%“ auch in die erste Zeile schreiben oder ganz weglassen.</translation>
    </message>
    <message>
        <source>Controls skip what is before or after it; keep one program per file.</source>
        <translation>Steuerungen überspringen, was davor oder danach steht; nur ein Programm je Datei behalten.</translation>
    </message>
    <message>
        <source>Add M30 as the last block.</source>
        <translation>M30 als letzten Satz anfügen.</translation>
    </message>
    <message>
        <source>Check that this is the right file and that it is complete.</source>
        <translation>Prüfen, ob dies die richtige Datei ist und ob sie vollständig ist.</translation>
    </message>
    <message>
        <source>Harmless here; save the file as plain text to remove them.</source>
        <translation>Hier harmlos; die Datei als reinen Text speichern, um sie zu entfernen.</translation>
    </message>
    <message>
        <source>Save it as UTF-8 without the mark, or as ASCII.</source>
        <translation>Als UTF-8 ohne BOM oder als ASCII speichern.</translation>
    </message>
    <message>
        <source>Save the file with LF or CR LF line ends.</source>
        <translation>Die Datei mit den Zeilenenden LF oder CR LF speichern.</translation>
    </message>
    <message>
        <source>Split the line.</source>
        <translation>Die Zeile aufteilen.</translation>
    </message>
    <message>
        <source>It is a label only; renumber the blocks.</source>
        <translation>Sie ist nur eine Marke; die Sätze neu nummerieren.</translation>
    </message>
    <message>
        <source>Raise the limit, or split the program.</source>
        <translation>Die Grenze erhöhen oder das Programm aufteilen.</translation>
    </message>
    <message>
        <source>Results after this block are unverified.</source>
        <translation>Die Ergebnisse nach diesem Satz sind ungeprüft.</translation>
    </message>
    <message>
        <source>Keep one of them, or make two blocks; this block is skipped.</source>
        <translation>Nur eines davon behalten oder auf zwei Sätze aufteilen; dieser Satz wird übersprungen.</translation>
    </message>
    <message>
        <source>Make several blocks of it; this block is skipped.</source>
        <translation>Auf mehrere Sätze aufteilen; dieser Satz wird übersprungen.</translation>
    </message>
    <message>
        <source>The motion is shown without it.</source>
        <translation>Die Bewegung wird ohne sie gezeigt.</translation>
    </message>
    <message>
        <source>Remove it, or add the code that it belongs to; this block is skipped.</source>
        <translation>Entfernen oder den zugehörigen Befehl ergänzen; dieser Satz wird übersprungen.</translation>
    </message>
    <message>
        <source>Write G0, G1, G2 or G3 into the block; this block is skipped.</source>
        <translation>G0, G1, G2 oder G3 in den Satz schreiben; dieser Satz wird übersprungen.</translation>
    </message>
    <message>
        <source>Controls differ here; move in a block of its own. This block is skipped.</source>
        <translation>Steuerungen verhalten sich hier verschieden; in einem eigenen Satz fahren. Dieser Satz wird übersprungen.</translation>
    </message>
    <message>
        <source>Add it; the code has no effect without it.</source>
        <translation>Ergänzen; ohne das Wort hat der Befehl keine Wirkung.</translation>
    </message>
    <message>
        <source>The word is ignored.</source>
        <translation>Das Wort wird ignoriert.</translation>
    </message>
    <message>
        <source>LinuxCNC reads F first; switch the unit in a block before.</source>
        <translation>LinuxCNC liest F zuerst; die Einheit in einem Satz davor umschalten.</translation>
    </message>
    <message>
        <source>Write the T word into the block or before it.</source>
        <translation>Das T-Wort in den Satz oder davor schreiben.</translation>
    </message>
    <message>
        <source>Give F in this block or before it; there is no default.</source>
        <translation>F in diesem Satz oder davor angeben; es gibt keine Vorgabe.</translation>
    </message>
    <message>
        <source>Position all axes with G0 before the first cut.</source>
        <translation>Vor dem ersten Schnitt alle Achsen mit G0 positionieren.</translation>
    </message>
    <message>
        <source>Position the axis in G90 first.</source>
        <translation>Die Achse zuerst mit G90 positionieren.</translation>
    </message>
    <message>
        <source>Give the centre with {} and {}, or the radius with R.</source>
        <translation>Den Mittelpunkt mit {} und {} oder den Radius mit R angeben.</translation>
    </message>
    <message>
        <source>Add the missing word, or use G91.1.</source>
        <translation>Das fehlende Wort ergänzen oder G91.1 verwenden.</translation>
    </message>
    <message>
        <source>Controls differ in which one they use; keep one.</source>
        <translation>Welches davon gilt, hängt von der Steuerung ab; nur eines behalten.</translation>
    </message>
    <message>
        <source>Remove the word, or select the plane that was meant.</source>
        <translation>Das Wort entfernen oder die gemeinte Ebene wählen.</translation>
    </message>
    <message>
        <source>The centre is at the start or end point.</source>
        <translation>Der Mittelpunkt liegt auf dem Start- oder dem Endpunkt.</translation>
    </message>
    <message>
        <source>Check the centre: I J K are from the start point, with G90.1 from the origin.</source>
        <translation>Den Mittelpunkt prüfen: I J K gelten ab dem Startpunkt, mit G90.1 ab dem Nullpunkt.</translation>
    </message>
    <message>
        <source>Give a full circle its centre, or make two arcs of it.</source>
        <translation>Für den Vollkreis den Mittelpunkt angeben oder zwei Kreisbögen daraus machen.</translation>
    </message>
    <message>
        <source>Check R and the end point.</source>
        <translation>R und den Endpunkt prüfen.</translation>
    </message>
    <message>
        <source>Check the centre; use G1 for a straight line.</source>
        <translation>Den Mittelpunkt prüfen; für eine Gerade G1 verwenden.</translation>
    </message>
    <message>
        <source>Check the P word.</source>
        <translation>Das P-Wort prüfen.</translation>
    </message>
    <message>
        <source>Save it as plain text (ASCII or UTF-8) and open it again.</source>
        <translation>Als reinen Text (ASCII oder UTF-8) speichern und erneut öffnen.</translation>
    </message>
    <message>
        <source>Choose the text file that the machine would run.</source>
        <translation>Die Textdatei wählen, die die Maschine ausführen würde.</translation>
    </message>
    <message>
        <source>Rapid move cuts stock ({} mm deep).</source>
        <translation>Eilgang fräst Rohteil ({} mm tief).</translation>
    </message>
    <message>
        <source>Retract above the stock before the rapid, or cut with G1.</source>
        <translation>Vor dem Eilgang über das Rohteil freifahren oder mit G1 fräsen.</translation>
    </message>
    <message>
        <source>The cut is {} mm deep, beyond the length of the flutes.</source>
        <translation>Der Schnitt ist {} mm tief, tiefer als die Schneidenlänge.</translation>
    </message>
    <message>
        <source>Cut in shallower passes, or choose a tool with longer flutes.</source>
        <translation>In kleineren Zustellungen fräsen oder ein Werkzeug mit längeren Schneiden wählen.</translation>
    </message>
    <message>
        <source>{} more findings of the simulation are not shown.</source>
        <translation>{} weitere Befunde der Simulation werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>The parameter &quot;{}&quot; is {}; it must be in {} … {}.</source>
        <translation>Der Parameter „{}“ ist {}; er muss in {} … {} liegen.</translation>
    </message>
    <message>
        <source>There is not enough memory for the simulation.</source>
        <translation>Der Speicher reicht nicht für die Simulation.</translation>
    </message>
    <message>
        <source>The simulation failed: {}.</source>
        <translation>Die Simulation ist fehlgeschlagen: {}.</translation>
    </message>
    <message>
        <source>There is no stock left to export.</source>
        <translation>Es ist kein Rohteil mehr übrig, das exportiert werden kann.</translation>
    </message>
    <message>
        <source>The export failed: {}.</source>
        <translation>Der Export ist fehlgeschlagen: {}.</translation>
    </message>
    <message>
        <source>There is no stock to export yet.</source>
        <translation>Es gibt noch kein Rohteil zum Exportieren.</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>blocks</source>
        <translation>Sätze</translation>
    </message>
    <message>
        <source>The rapid move comes from an unknown position and ends {} mm below the top of the stock; what it cuts is unknown.</source>
        <translation>Der Eilgang kommt von einer unbekannten Position und endet {} mm unter der Oberseite des Rohteils; was er fräst, ist unbekannt.</translation>
    </message>
    <message>
        <source>The file cannot be written: {}.</source>
        <translation>Die Datei kann nicht geschrieben werden: {}.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; is not known and has no effect.</source>
        <translation>Das Feld „{}“ ist unbekannt und bleibt ohne Wirkung.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; is not known and has no effect; perhaps &quot;{}&quot; is meant.</source>
        <translation>Das Feld „{}“ ist unbekannt und bleibt ohne Wirkung; vielleicht ist „{}“ gemeint.</translation>
    </message>
    <message>
        <source>Correct its name, or remove it.</source>
        <translation>Den Namen berichtigen oder das Feld entfernen.</translation>
    </message>
    <message>
        <source>“{}” is not a table of a tool file; each tool is a [[tool]].</source>
        <translation>„{}“ ist keine Tabelle einer Werkzeugdatei; jedes Werkzeug ist ein [[tool]].</translation>
    </message>
    <message>
        <source>“{}” is not a table of a tool file; perhaps “{}” is meant.</source>
        <translation>„{}“ ist keine Tabelle einer Werkzeugdatei; vielleicht ist „{}“ gemeint.</translation>
    </message>
    <message>
        <source>“{}” is not a key of a tool; there are {}.</source>
        <translation>„{}“ ist kein Schlüssel eines Werkzeugs; gültig sind: {}.</translation>
    </message>
    <message>
        <source>“{}” is not a key of a tool; perhaps “{}” is meant.</source>
        <translation>„{}“ ist kein Schlüssel eines Werkzeugs; vielleicht ist „{}“ gemeint.</translation>
    </message>
    <message>
        <source>There is not enough memory to interpret the program.</source>
        <translation>Der Speicher reicht nicht, um das Programm zu interpretieren.</translation>
    </message>
    <message>
        <source>Interpreting the program failed: {}.</source>
        <translation>Das Interpretieren des Programms ist fehlgeschlagen: {}.</translation>
    </message>
    <message>
        <source>A file is still being written. Wait for it, or cancel it.</source>
        <translation>Eine Datei wird noch geschrieben. Warten oder abbrechen.</translation>
    </message>
    <message>
        <source>The value of {}, “{}”, is not a number.</source>
        <translation>Der Wert von {}, „{}“, ist keine Zahl.</translation>
    </message>
    <message>
        <source>{}={} is out of range, {} to {} {}.</source>
        <translation>{}={} liegt außerhalb der Grenzen {} bis {} {}.</translation>
    </message>
    <message>
        <source>The key {} is specified twice.</source>
        <translation>Der Schlüssel {} ist doppelt angegeben.</translation>
    </message>
    <message>
        <source>“{}” is not a key of this cutter shape; there are {}.</source>
        <translation>„{}“ ist kein Schlüssel dieser Fräserform; gültig sind: {}.</translation>
    </message>
    <message>
        <source>A cutter of the shape {} needs the key {} ({}, {} to {} {}).</source>
        <translation>Ein Fräser der Form {} braucht den Schlüssel {} ({}, {} bis {} {}).</translation>
    </message>
    <message>
        <source>“{}” is not a cutter shape; there are {}.</source>
        <translation>„{}“ ist keine Fräserform; gültig sind: {}.</translation>
    </message>
    <message>
        <source>The flute length l={} is less than the height of the cutter&apos;s profile, {} mm.</source>
        <translation>Die Schneidenlänge l={} ist kleiner als die Höhe des Fräserprofils, {} mm.</translation>
    </message>
    <message>
        <source>The corner radius r={} is larger than half the diameter, {} mm.</source>
        <translation>Der Eckenradius r={} ist größer als der halbe Durchmesser, {} mm.</translation>
    </message>
    <message>
        <source>The flat tip tip={} is not smaller than the diameter, {} mm.</source>
        <translation>Die flache Spitze tip={} ist nicht kleiner als der Durchmesser, {} mm.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; has no meaning here.</source>
        <translation>„{}“ hat hier keine Bedeutung.</translation>
    </message>
    <message>
        <source>{} word without a value.</source>
        <translation>Wort {} ohne Wert.</translation>
    </message>
    <message>
        <source>The value of {} has two signs.</source>
        <translation>Der Wert von {} hat zwei Vorzeichen.</translation>
    </message>
    <message>
        <source>The value of {} has two decimal points.</source>
        <translation>Der Wert von {} hat zwei Dezimalpunkte.</translation>
    </message>
    <message>
        <source>The value of {} is out of range: larger than 1e12.</source>
        <translation>Der Wert von {} liegt außerhalb des Bereichs: größer als 1e12.</translation>
    </message>
    <message>
        <source>The comment is not closed.</source>
        <translation>Der Kommentar ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>A comment is nested in a comment.</source>
        <translation>Ein Kommentar ist in einem Kommentar verschachtelt.</translation>
    </message>
    <message>
        <source>Duplicate {} word.</source>
        <translation>Doppeltes Wort {}.</translation>
    </message>
    <message>
        <source>The block has more than 24 G and M words.</source>
        <translation>Der Satz hat mehr als 24 G- und M-Wörter.</translation>
    </message>
    <message>
        <source>The N word does not begin the block.</source>
        <translation>Das N-Wort steht nicht am Anfang des Satzes.</translation>
    </message>
    <message>
        <source>The block number is negative.</source>
        <translation>Die Satznummer ist negativ.</translation>
    </message>
    <message>
        <source>&quot;%&quot; marks the beginning and the end of a tape and must be alone on its line.</source>
        <translation>„%“ kennzeichnet Anfang und Ende eines Lochstreifens und muss allein in der Zeile stehen.</translation>
    </message>
    <message>
        <source>The program ends with &quot;%&quot; but does not begin with it.</source>
        <translation>Das Programm endet mit „%“, beginnt aber nicht damit.</translation>
    </message>
    <message>
        <source>&quot;%&quot; is in the middle of the program.</source>
        <translation>„%“ steht mitten im Programm.</translation>
    </message>
    <message>
        <source>The text after the second &quot;%&quot; is not run.</source>
        <translation>Der Text nach dem zweiten „%“ wird nicht ausgeführt.</translation>
    </message>
    <message>
        <source>The blocks after the program end are not run.</source>
        <translation>Die Sätze nach dem Programmende werden nicht ausgeführt.</translation>
    </message>
    <message>
        <source>The program has no end: M2, M30 or a pair of &quot;%&quot;.</source>
        <translation>Das Programm hat kein Ende: M2, M30 oder ein Paar „%“.</translation>
    </message>
    <message>
        <source>The program has no motion.</source>
        <translation>Das Programm hat keine Bewegung.</translation>
    </message>
    <message>
        <source>Control codes of a tape or a serial line were skipped.</source>
        <translation>Steuerzeichen eines Lochstreifens oder einer seriellen Leitung wurden übersprungen.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark, which controls reject.</source>
        <translation>Die Datei beginnt mit einem Byte-Order-Mark (BOM), das Steuerungen ablehnen.</translation>
    </message>
    <message>
        <source>The line ends with CR alone, which LinuxCNC does not accept as a line end.</source>
        <translation>Die Zeile endet mit CR allein, was LinuxCNC nicht als Zeilenende akzeptiert.</translation>
    </message>
    <message>
        <source>The line has {} characters; LinuxCNC refuses more than 252.</source>
        <translation>Die Zeile hat {} Zeichen; LinuxCNC lehnt mehr als 252 ab.</translation>
    </message>
    <message>
        <source>The block number has more than 15 digits, which controls cannot hold.</source>
        <translation>Die Satznummer hat mehr als 15 Stellen, mehr, als Steuerungen fassen.</translation>
    </message>
    <message>
        <source>The program has more than {} motions; interpretation ends here.</source>
        <translation>Das Programm hat mehr als {} Bewegungen; die Interpretation endet hier.</translation>
    </message>
    <message>
        <source>{} more messages are not shown.</source>
        <translation>{} weitere Meldungen werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>{} is not a known code.</source>
        <translation>{} ist kein bekannter Befehl.</translation>
    </message>
    <message>
        <source>{} ({}) is not supported yet.</source>
        <translation>{} ({}) wird noch nicht unterstützt.</translation>
    </message>
    <message>
        <source>{} and {} cannot be used in one block.</source>
        <translation>{} und {} sind in einem Satz nicht zusammen zulässig.</translation>
    </message>
    <message>
        <source>{} axis ignored (three-axis machine).</source>
        <translation>Achse {} ignoriert (Dreiachsmaschine).</translation>
    </message>
    <message>
        <source>No code of this block uses the word {}.</source>
        <translation>Kein Befehl dieses Satzes verwendet das Wort {}.</translation>
    </message>
    <message>
        <source>No motion code is active for the word {}.</source>
        <translation>Für das Wort {} ist kein Bewegungsbefehl aktiv.</translation>
    </message>
    <message>
        <source>G80 cannot move the axis {}.</source>
        <translation>G80 kann die Achse {} nicht bewegen.</translation>
    </message>
    <message>
        <source>{} needs the word {}.</source>
        <translation>{} braucht das Wort {}.</translation>
    </message>
    <message>
        <source>The value of {} must not be negative.</source>
        <translation>Der Wert von {} darf nicht negativ sein.</translation>
    </message>
    <message>
        <source>The value of {} must be a whole number from {} to {}.</source>
        <translation>Der Wert von {} muss eine ganze Zahl von {} bis {} sein.</translation>
    </message>
    <message>
        <source>The feed is read in the unit that was in force before {}.</source>
        <translation>Der Vorschub wird in der Einheit gelesen, die vor {} galt.</translation>
    </message>
    <message>
        <source>M6 changes the tool, but none is selected.</source>
        <translation>M6 wechselt das Werkzeug, aber es ist keines gewählt.</translation>
    </message>
    <message>
        <source>A cutting motion has no feed rate.</source>
        <translation>Für eine Vorschubbewegung fehlt der Vorschub.</translation>
    </message>
    <message>
        <source>{} position unknown; move not simulated.</source>
        <translation>Position von {} unbekannt; die Bewegung wird nicht simuliert.</translation>
    </message>
    <message>
        <source>{} moves by an incremental distance from an unknown position.</source>
        <translation>{} fährt um einen inkrementalen Weg von einer unbekannten Position aus.</translation>
    </message>
    <message>
        <source>The arc has neither a centre nor a radius.</source>
        <translation>Der Kreisbogen hat weder Mittelpunkt noch Radius.</translation>
    </message>
    <message>
        <source>An absolute centre (G90.1) needs both {} and {}.</source>
        <translation>Ein absoluter Mittelpunkt (G90.1) braucht {} und {}.</translation>
    </message>
    <message>
        <source>The arc has both a centre and a radius.</source>
        <translation>Der Kreisbogen hat Mittelpunkt und Radius zugleich.</translation>
    </message>
    <message>
        <source>The word {} does not belong to an arc in the plane of {}.</source>
        <translation>Das Wort {} gehört nicht zu einem Kreisbogen in der Ebene von {}.</translation>
    </message>
    <message>
        <source>The arc has no radius: {} mm.</source>
        <translation>Der Kreisbogen hat keinen Radius: {} mm.</translation>
    </message>
    <message>
        <source>The arc does not fit: radius {} mm at its start, {} mm at its end, {} mm apart.</source>
        <translation>Der Kreisbogen passt nicht: Radius {} mm am Anfang, {} mm am Ende, {} mm Unterschied.</translation>
    </message>
    <message>
        <source>An arc with R cannot end where it begins.</source>
        <translation>Ein Kreisbogen mit R kann nicht an seinem Anfang enden.</translation>
    </message>
    <message>
        <source>The radius {} mm is too small: the end is {} mm from the start, {} mm more than 2 R.</source>
        <translation>Der Radius {} mm ist zu klein: Der Endpunkt liegt {} mm vom Startpunkt entfernt, {} mm mehr als 2 R.</translation>
    </message>
    <message>
        <source>The radius of the arc is {} mm, beyond what can be computed exactly.</source>
        <translation>Der Radius des Kreisbogens ist {} mm, mehr, als sich genau rechnen lässt.</translation>
    </message>
    <message>
        <source>P must be a whole number of turns from 1 to {}.</source>
        <translation>P muss eine ganze Zahl von Umläufen von 1 bis {} sein.</translation>
    </message>
    <message>
        <source>The file is encoded in {}, not in ASCII or UTF-8.</source>
        <translation>Die Datei ist in {} kodiert, nicht in ASCII oder UTF-8.</translation>
    </message>
    <message>
        <source>This is not an NC program: it holds binary data.</source>
        <translation>Das ist kein NC-Programm: Es enthält Binärdaten.</translation>
    </message>
    <message>
        <source>The grid spacing {} mm is not a number above 0.</source>
        <translation>Die Rasterweite {} mm ist keine Zahl über 0.</translation>
    </message>
    <message>
        <source>Each side of the stock {} must be above 0 and at most {} mm.</source>
        <translation>Jede Seite des Rohteils {} muss über 0 und höchstens {} mm lang sein.</translation>
    </message>
    <message>
        <source>The stock {} is too narrow: its sides in X and Y may differ by a factor of {} at most.</source>
        <translation>Das Rohteil {} ist zu schmal: Seine Seiten in X und Y dürfen sich höchstens um den Faktor {} unterscheiden.</translation>
    </message>
    <message>
        <source>The origin of the stock is not three numbers from -{} to {} mm.</source>
        <translation>Der Ursprung des Rohteils besteht nicht aus drei Zahlen von -{} bis {} mm.</translation>
    </message>
    <message>
        <source>The box {} has no area: each side must go from the smaller coordinate to the larger one.</source>
        <translation>Der Bereich {} hat keine Fläche: Jede Seite muss von der kleineren zur größeren Koordinate gehen.</translation>
    </message>
    <message>
        <source>The box {} is not within the stock, {}.</source>
        <translation>Der Bereich {} liegt nicht innerhalb des Rohteils, {}.</translation>
    </message>
    <message>
        <source>A detail region of {} × {} points needs {}; {} is available, enough for a spacing of {} mm.</source>
        <translation>Ein Detailbereich von {} × {} Punkten braucht {}; verfügbar sind {}, genug für eine Rasterweite von {} mm.</translation>
    </message>
    <message>
        <source>The grid spacing {} mm is too coarse for the stock {}; the coarsest possible is {} mm.</source>
        <translation>Die Rasterweite {} mm ist zu grob für das Rohteil {}; die gröbste mögliche ist {} mm.</translation>
    </message>
    <message>
        <source>The grid spacing {} mm makes {} points on the stock {}, {} of memory; the finest possible is {} mm.</source>
        <translation>Die Rasterweite {} mm ergibt {} Punkte auf dem Rohteil {}, {} Speicher; die feinste mögliche ist {} mm.</translation>
    </message>
    <message>
        <source>The grid spacing {} mm is lost in the rounding of coordinates as large as {} mm.</source>
        <translation>Die Rasterweite {} mm geht im Runden so großer Koordinaten wie {} mm verloren.</translation>
    </message>
    <message>
        <source>“{}” is not a stock size of the form WxDxH in mm, as in {}.</source>
        <translation>„{}“ ist keine Rohteilgröße der Form BxTxH in mm wie in {}.</translation>
    </message>
    <message>
        <source>Every side of the stock must be more than 0 mm, not “{}”.</source>
        <translation>Jede Seite des Rohteils muss größer als 0 mm sein, nicht „{}“.</translation>
    </message>
    <message>
        <source>“{}” is not a point of the form X,Y,Z in mm.</source>
        <translation>„{}“ ist kein Punkt der Form X,Y,Z in mm.</translation>
    </message>
    <message>
        <source>The motion ends more than {} mm from machine zero, along {}.</source>
        <translation>Die Bewegung endet mehr als {} mm vom Maschinennullpunkt entfernt, entlang {}.</translation>
    </message>
    <message>
        <source>Check the values, the scaling and the repeats.</source>
        <translation>Werte, Skalierung und Wiederholungen prüfen.</translation>
    </message>
    <message>
        <source>The path of the arc is {} mm long, beyond the limit of {} mm; it cuts nothing.</source>
        <translation>Die Bahn des Kreisbogens ist {} mm lang, mehr als die Grenze von {} mm; er fräst nichts.</translation>
    </message>
    <message>
        <source>Check the centre and the number of turns.</source>
        <translation>Mittelpunkt und Anzahl der Umläufe prüfen.</translation>
    </message>
    <message>
        <source>Point angle</source>
        <translation>Spitzenwinkel</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>The program never positions {}, so what it cuts is unknown.</source>
        <translation>Das Programm positioniert {} nie; was es fräst, ist daher unbekannt.</translation>
    </message>
    <message>
        <source>The rapid move passes over the stock at an unknown height; whether it cuts is unknown.</source>
        <translation>Der Eilgang führt in unbekannter Höhe über das Rohteil; ob er fräst, ist unbekannt.</translation>
    </message>
    <message>
        <source>Position Z above the stock before the rapid.</source>
        <translation>Vor dem Eilgang Z über dem Rohteil positionieren.</translation>
    </message>
    <message>
        <source>This is a folder, not a file.</source>
        <translation>Das ist ein Ordner, keine Datei.</translation>
    </message>
    <message>
        <source>The export needs {} of memory; only {} is available, enough for a grid spacing of {} mm.</source>
        <translation>Der Export braucht {} Speicher; nur {} sind verfügbar, genug für eine Rasterweite von {} mm.</translation>
    </message>
    <message>
        <source>The export needs {} of memory; only {} is available.</source>
        <translation>Der Export braucht {} Speicher; nur {} sind verfügbar.</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>PLY, binary</source>
        <translation>PLY, binär</translation>
    </message>
    <message>
        <source>3MF</source>
        <translation>3MF</translation>
    </message>
    <message>
        <source>The extension of this name is not that of a mesh format; there are {}.</source>
        <translation>Die Endung dieses Namens gehört zu keinem Netzformat; gültig sind: {}.</translation>
    </message>
    <message>
        <source>The vertex {}, {}, {} is not finite: a mesh file holds finite numbers only.</source>
        <translation>Der Eckpunkt {}, {}, {} ist nicht endlich: Eine Netzdatei fasst nur endliche Zahlen.</translation>
    </message>
    <message>
        <source>Certified</source>
        <translation>Zertifiziert</translation>
    </message>
    <message>
        <source>At every z-map point</source>
        <translation>An jedem Punkt der Z-Map</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Error level</source>
        <translation>Fehlerschranke gilt</translation>
    </message>
    <message>
        <source>Where the certified method keeps its surface within the error allowance, at rest and in exports; while cutting, it is at every z-map point.</source>
        <translation>Wo das zertifizierte Verfahren seine Fläche innerhalb des zulässigen Fehlers hält, in Ruhe und beim Export; während des Fräsens gilt das an jedem Punkt der Z-Map.</translation>
    </message>
    <message>
        <source>ε = 0 (no decimation)</source>
        <translation>ε = 0 (ohne Dezimierung)</translation>
    </message>
    <message>
        <source>with certificate</source>
        <translation>mit Zertifikat</translation>
    </message>
    <message>
        <source>as in the paper</source>
        <translation>wie im Aufsatz</translation>
    </message>
    <message>
        <source>regions {} × {}</source>
        <translation>Regionen {} × {}</translation>
    </message>
    <message>
        <source>No decimation</source>
        <translation>Ohne Dezimierung</translation>
    </message>
    <message>
        <source>Global, after each block</source>
        <translation>Global, nach jedem Satz</translation>
    </message>
    <message>
        <source>Local, s = {}</source>
        <translation>Lokal, s = {}</translation>
    </message>
    <message>
        <source>averages over {} steps</source>
        <translation>Mittel über {} Schritte</translation>
    </message>
    <message>
        <source>Step (block)</source>
        <translation>Schritt (Satz)</translation>
    </message>
    <message>
        <source>Region size, cells</source>
        <translation>Regionsgröße, Zellen</translation>
    </message>
    <message>
        <source>Decimation time, s</source>
        <translation>Dezimierungszeit, s</translation>
    </message>
    <message>
        <source>Triangles shown in all frames</source>
        <translation>Gezeigte Dreiecke aller Bilder</translation>
    </message>
    <message>
        <source>Time, random</source>
        <translation>Zeit, zufällig</translation>
    </message>
    <message>
        <source>Time, sequential</source>
        <translation>Zeit, der Reihe nach</translation>
    </message>
    <message>
        <source>Triangles, random</source>
        <translation>Dreiecke, zufällig</translation>
    </message>
    <message>
        <source>Triangles, sequential</source>
        <translation>Dreiecke, der Reihe nach</translation>
    </message>
    <message>
        <source>Error allowance ε, mm</source>
        <translation>Zulässiger Fehler ε, mm</translation>
    </message>
    <message>
        <source>Ratio to ε = 0</source>
        <translation>Verhältnis zu ε = 0</translation>
    </message>
    <message>
        <source>Number of triangles</source>
        <translation>Anzahl der Dreiecke</translation>
    </message>
    <message>
        <source>each step</source>
        <translation>jeder Schritt</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>Decimation period s, blocks</source>
        <translation>Dezimierungsperiode s, Sätze</translation>
    </message>
    <message>
        <source>Time, s = -1</source>
        <translation>Zeit, s = -1</translation>
    </message>
    <message>
        <source>Time, no decimation</source>
        <translation>Zeit, ohne Dezimierung</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Global and local decimation: rendering time of each frame</source>
        <translation>Globale und lokale Dezimierung: Darstellungszeit jedes Bildes</translation>
    </message>
    <message>
        <source>Decimation time and triangles by the order of removal</source>
        <translation>Dezimierungszeit und Dreiecke nach Reihenfolge des Entfernens</translation>
    </message>
    <message>
        <source>Rendering time and region size</source>
        <translation>Darstellungszeit und Regionsgröße</translation>
    </message>
    <message>
        <source>Triangles and rendering time against no decimation</source>
        <translation>Dreiecke und Darstellungszeit im Verhältnis zu ohne Dezimierung</translation>
    </message>
    <message>
        <source>Number of triangles of each frame</source>
        <translation>Anzahl der Dreiecke jedes Bildes</translation>
    </message>
    <message>
        <source>Rendering time of each frame, averages over 20 steps</source>
        <translation>Darstellungszeit jedes Bildes, Mittel über 20 Schritte</translation>
    </message>
    <message>
        <source>Number of triangles and rendering time by the decimation period</source>
        <translation>Anzahl der Dreiecke und Darstellungszeit nach Dezimierungsperiode</translation>
    </message>
    <message>
        <source>Predicted cost by region size and period</source>
        <translation>Vorhergesagter Aufwand nach Regionsgröße und Periode</translation>
    </message>
    <message>
        <source>Cost of the program, s</source>
        <translation>Aufwand des Programms, s</translation>
    </message>
    <message>
        <source>The study was stopped.</source>
        <translation>Die Studie wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Only a method that decimates region by region, with an allowance above 0, has a region size and a period to choose.</source>
        <translation>Nur ein Verfahren, das Region für Region dezimiert, mit einem zulässigen Fehler über 0, hat eine Regionsgröße und eine Periode zu wählen.</translation>
    </message>
    <message>
        <source>There is not enough memory for the study.</source>
        <translation>Der Speicher reicht nicht für die Studie.</translation>
    </message>
    <message>
        <source>The study failed: {}.</source>
        <translation>Die Studie ist fehlgeschlagen: {}.</translation>
    </message>
    <message>
        <source>OpenGL 3.3 is not available.</source>
        <translation>OpenGL 3.3 ist nicht verfügbar.</translation>
    </message>
    <message>
        <source>The motions of the program need more than {} of memory; interpretation ends here.</source>
        <translation>Die Bewegungen des Programms brauchen mehr als {} Speicher; die Interpretation endet hier.</translation>
    </message>
    <message>
        <source>Close other programs, or split the program.</source>
        <translation>Andere Programme schließen oder das NC-Programm aufteilen.</translation>
    </message>
    <message>
        <source>The program has more than {} tool changes, stops, dwells and the like; interpretation ends here.</source>
        <translation>Das Programm hat mehr als {} Werkzeugwechsel, Halte, Verweilzeiten und dergleichen; die Interpretation endet hier.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; names a tool that is in the table already.</source>
        <translation>Das Feld „{}“ nennt ein Werkzeug, das schon in der Tabelle steht.</translation>
    </message>
    <message>
        <source>The method “{}” works on maps of {} points at most; this one has {}.</source>
        <translation>Das Verfahren „{}“ arbeitet auf Z-Maps mit höchstens {} Punkten; diese hat {}.</translation>
    </message>
    <message>
        <source>The z-map needs {}; {} is available.</source>
        <translation>Die Z-Map braucht {}; verfügbar sind {}.</translation>
    </message>
    <message>
        <source>A grid of {} × {} points needs {}; {} is available, enough for a spacing of {} mm.</source>
        <translation>Ein Raster von {} × {} Punkten braucht {}; verfügbar sind {}, genug für eine Rasterweite von {} mm.</translation>
    </message>
    <message>
        <source>Increase the grid spacing, or close other programs.</source>
        <translation>Die Rasterweite vergrößern oder andere Programme schließen.</translation>
    </message>
    <message>
        <source>polar radius</source>
        <translation>Polarradius</translation>
    </message>
    <message>
        <source>polar angle in degrees</source>
        <translation>Polarwinkel in Grad</translation>
    </message>
    <message>
        <source>The expression is nested deeper than 100 levels.</source>
        <translation>Der Ausdruck ist tiefer als 100 Ebenen geschachtelt.</translation>
    </message>
    <message>
        <source>Compute it in several steps.</source>
        <translation>In mehreren Schritten berechnen.</translation>
    </message>
    <message>
        <source>The parameter {} was never set.</source>
        <translation>Der Parameter {} wurde nie gesetzt.</translation>
    </message>
    <message>
        <source>Set it first; a name without _ at its front is known in its own subprogram only.</source>
        <translation>Zuerst setzen; ein Name ohne _ am Anfang gilt nur in seinem eigenen Unterprogramm.</translation>
    </message>
    <message>
        <source>{} is not a whole number, so it is not a parameter number.</source>
        <translation>{} ist keine ganze Zahl und daher keine Parameternummer.</translation>
    </message>
    <message>
        <source>Round it with FIX or ROUND.</source>
        <translation>Mit FIX oder ROUND runden.</translation>
    </message>
    <message>
        <source>Use another number, or a name.</source>
        <translation>Eine andere Nummer oder einen Namen verwenden.</translation>
    </message>
    <message>
        <source>The parameter {} can be read only.</source>
        <translation>Der Parameter {} kann nur gelesen werden.</translation>
    </message>
    <message>
        <source>Use another number.</source>
        <translation>Eine andere Nummer verwenden.</translation>
    </message>
    <message>
        <source>The name is not closed.</source>
        <translation>Der Name ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>Close it with &quot;&gt;&quot;.</source>
        <translation>Mit „&gt;“ schließen.</translation>
    </message>
    <message>
        <source>The name is empty.</source>
        <translation>Der Name ist leer.</translation>
    </message>
    <message>
        <source>Write a name between &quot;&lt;&quot; and &quot;&gt;&quot;.</source>
        <translation>Einen Namen zwischen „&lt;“ und „&gt;“ schreiben.</translation>
    </message>
    <message>
        <source>The name has more than 256 characters.</source>
        <translation>Der Name hat mehr als 256 Zeichen.</translation>
    </message>
    <message>
        <source>Use a shorter one.</source>
        <translation>Einen kürzeren verwenden.</translation>
    </message>
    <message>
        <source>The program has more than 100000 named parameters at once; {} was not set.</source>
        <translation>Das Programm hat mehr als 100000 benannte Parameter zugleich; {} wurde nicht gesetzt.</translation>
    </message>
    <message>
        <source>Use fewer names, or numbers.</source>
        <translation>Weniger Namen oder stattdessen Nummern verwenden.</translation>
    </message>
    <message>
        <source>The bracket is not closed.</source>
        <translation>Die eckige Klammer ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>Close it with &quot;]&quot; in the same line.</source>
        <translation>In derselben Zeile mit „]“ schließen.</translation>
    </message>
    <message>
        <source>{} has no argument in brackets.</source>
        <translation>{} hat kein Argument in eckigen Klammern.</translation>
    </message>
    <message>
        <source>Write for example SIN[30].</source>
        <translation>Zum Beispiel SIN[30] schreiben.</translation>
    </message>
    <message>
        <source>Expected an operator or &quot;]&quot; but found &quot;{}&quot;.</source>
        <translation>Operator oder „]“ erwartet, aber „{}“ gefunden.</translation>
    </message>
    <message>
        <source>Check the expression.</source>
        <translation>Den Ausdruck prüfen.</translation>
    </message>
    <message>
        <source>{} has no result for these values.</source>
        <translation>{} hat für diese Werte kein Ergebnis.</translation>
    </message>
    <message>
        <source>Check for a division by zero, the root of a negative number, an arc sine beyond 1.</source>
        <translation>Auf Division durch null, die Wurzel einer negativen Zahl oder den Arkussinus eines Werts über 1 prüfen.</translation>
    </message>
    <message>
        <source>EXISTS asks for a named parameter: EXISTS[#&lt;name&gt;].</source>
        <translation>EXISTS verlangt einen benannten Parameter: EXISTS[#&lt;Name&gt;].</translation>
    </message>
    <message>
        <source>Write the name between &quot;&lt;&quot; and &quot;&gt;&quot;.</source>
        <translation>Den Namen zwischen „&lt;“ und „&gt;“ schreiben.</translation>
    </message>
    <message>
        <source>{} is not followed by &quot;=&quot; and a value.</source>
        <translation>Auf {} folgen nicht „=“ und ein Wert.</translation>
    </message>
    <message>
        <source>A parameter at the beginning of a word is an assignment, for example #1=10.</source>
        <translation>Ein Parameter am Anfang eines Wortes ist eine Zuweisung, zum Beispiel #1=10.</translation>
    </message>
    <message>
        <source>The number after O is not a whole number from 0 up.</source>
        <translation>Die Zahl nach O ist keine ganze Zahl ab 0.</translation>
    </message>
    <message>
        <source>Use a whole number, or a name: O&lt;name&gt;.</source>
        <translation>Eine ganze Zahl oder einen Namen verwenden: O&lt;Name&gt;.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not an O-word keyword.</source>
        <translation>„{}“ ist kein O-Wort-Schlüsselwort.</translation>
    </message>
    <message>
        <source>Use sub, endsub, call, return, if, elseif, else, endif, do, while, endwhile, repeat, endrepeat, break or continue.</source>
        <translation>Erlaubt sind sub, endsub, call, return, if, elseif, else, endif, do, while, endwhile, repeat, endrepeat, break und continue.</translation>
    </message>
    <message>
        <source>The O word does not begin the block.</source>
        <translation>Das O-Wort steht nicht am Anfang des Satzes.</translation>
    </message>
    <message>
        <source>Put it on a line of its own.</source>
        <translation>In eine eigene Zeile schreiben.</translation>
    </message>
    <message>
        <source>Unexpected &quot;{}&quot; after the O word and its arguments.</source>
        <translation>Unerwartetes „{}“ nach dem O-Wort und seinen Argumenten.</translation>
    </message>
    <message>
        <source>O{} {} has no matching {}.</source>
        <translation>Zu O{} {} fehlt das zugehörige {}.</translation>
    </message>
    <message>
        <source>Both need the same label, in the same subprogram.</source>
        <translation>Beide brauchen dieselbe Marke, im selben Unterprogramm.</translation>
    </message>
    <message>
        <source>The label O{} is used already in line {} of this subprogram or main program.</source>
        <translation>Die Marke O{} wird schon in Zeile {} dieses Unterprogramms oder Hauptprogramms verwendet.</translation>
    </message>
    <message>
        <source>Give each branch and each loop a label of its own.</source>
        <translation>Jeder Verzweigung und jeder Schleife eine eigene Marke geben.</translation>
    </message>
    <message>
        <source>After continue in a do loop, LinuxCNC may run a repeat loop twice as often as it says.</source>
        <translation>Nach continue in einer do-Schleife durchläuft LinuxCNC eine repeat-Schleife unter Umständen doppelt so oft, wie sie angibt.</translation>
    </message>
    <message>
        <source>Skip the rest of the pass with if and endif instead of continue.</source>
        <translation>Den Rest des Durchlaufs mit if und endif statt mit continue überspringen.</translation>
    </message>
    <message>
        <source>M98 with L0 runs nothing, but LinuxCNC then loses the named parameters of this program and refuses the next subprogram.</source>
        <translation>M98 mit L0 führt nichts aus, aber LinuxCNC verliert danach die benannten Parameter dieses Programms und lehnt das nächste Unterprogramm ab.</translation>
    </message>
    <message>
        <source>Leave out the call.</source>
        <translation>Den Aufruf weglassen.</translation>
    </message>
    <message>
        <source>O{} sub is inside another subprogram.</source>
        <translation>O{} sub steht innerhalb eines anderen Unterprogramms.</translation>
    </message>
    <message>
        <source>Close the other one with endsub before it.</source>
        <translation>Das andere davor mit endsub abschließen.</translation>
    </message>
    <message>
        <source>{} needs a condition in brackets.</source>
        <translation>{} braucht eine Bedingung in eckigen Klammern.</translation>
    </message>
    <message>
        <source>Write for example: O1 if [#1 GT 0].</source>
        <translation>Zum Beispiel schreiben: O1 if [#1 GT 0].</translation>
    </message>
    <message>
        <source>There is no subprogram {}, in this file or as {}.</source>
        <translation>Es gibt kein Unterprogramm {}, weder in dieser Datei noch als {}.</translation>
    </message>
    <message>
        <source>Check the name and the folders of subprograms.</source>
        <translation>Den Namen und die Unterprogrammordner prüfen.</translation>
    </message>
    <message>
        <source>The subprogram {} is not opened: its name leads outside the subprogram folders.</source>
        <translation>Das Unterprogramm {} wird nicht geöffnet: Sein Name führt aus den Unterprogrammordnern hinaus.</translation>
    </message>
    <message>
        <source>Use a name without &quot;/&quot; and &quot;..&quot;.</source>
        <translation>Einen Namen ohne „/“ und „..“ verwenden.</translation>
    </message>
    <message>
        <source>The subprogram {} cannot be read: {}</source>
        <translation>Das Unterprogramm {} lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>Check the file.</source>
        <translation>Die Datei prüfen.</translation>
    </message>
    <message>
        <source>The file ends within the subprogram {}.</source>
        <translation>Die Datei endet innerhalb des Unterprogramms {}.</translation>
    </message>
    <message>
        <source>Close it with endsub or M99.</source>
        <translation>Mit endsub oder M99 abschließen.</translation>
    </message>
    <message>
        <source>Subprograms call each other deeper than {} levels: {}.</source>
        <translation>Unterprogramme rufen einander tiefer als {} Ebenen auf: {}.</translation>
    </message>
    <message>
        <source>Check for a subprogram that calls itself endlessly.</source>
        <translation>Prüfen, ob ein Unterprogramm sich endlos selbst aufruft.</translation>
    </message>
    <message>
        <source>The call has more than 30 arguments.</source>
        <translation>Der Aufruf hat mehr als 30 Argumente.</translation>
    </message>
    <message>
        <source>Pass the others in global parameters.</source>
        <translation>Die übrigen in globalen Parametern übergeben.</translation>
    </message>
    <message>
        <source>{} is outside a subprogram.</source>
        <translation>{} steht außerhalb eines Unterprogramms.</translation>
    </message>
    <message>
        <source>Remove it, or put it between sub and endsub.</source>
        <translation>Entfernen oder zwischen sub und endsub setzen.</translation>
    </message>
    <message>
        <source>M99 ends the main program: the control restarts it, endlessly.</source>
        <translation>M99 beendet das Hauptprogramm: Die Steuerung startet es endlos neu.</translation>
    </message>
    <message>
        <source>It is run once here; use M30 if the program should end.</source>
        <translation>Hier wird es einmal ausgeführt; M30 verwenden, wenn das Programm enden soll.</translation>
    </message>
    <message>
        <source>{} does not begin its block; LinuxCNC looks for it there only.</source>
        <translation>{} steht nicht am Anfang des Satzes; LinuxCNC sucht es nur dort.</translation>
    </message>
    <message>
        <source>Put it first in the block.</source>
        <translation>An den Satzanfang schreiben.</translation>
    </message>
    <message>
        <source>M99 is not alone in its block; LinuxCNC stops there with an error.</source>
        <translation>M99 steht nicht allein im Satz; LinuxCNC hält dort mit einem Fehler an.</translation>
    </message>
    <message>
        <source>The repeated lines and their motions exceed {}; interpretation ends in line {}.</source>
        <translation>Die wiederholten Zeilen und ihre Bewegungen überschreiten {}; die Interpretation endet in Zeile {}.</translation>
    </message>
    <message>
        <source>Check loops and repeat counts. The motions of this repetition are not shown.</source>
        <translation>Schleifen und Wiederholungszahlen prüfen. Die Bewegungen dieser Wiederholung werden nicht angezeigt.</translation>
    </message>
    <message>
        <source>More than {} repeated lines in a row make no motion; interpretation ends in line {}.</source>
        <translation>Mehr als {} wiederholte Zeilen in Folge erzeugen keine Bewegung; die Interpretation endet in Zeile {}.</translation>
    </message>
    <message>
        <source>Check the loop for an end.</source>
        <translation>Prüfen, ob die Schleife endet.</translation>
    </message>
    <message>
        <source>This loop never ends: line {} jumps back to line {} and no variable changes from one pass to the next.</source>
        <translation>Diese Schleife endet nie: Zeile {} springt zurück zu Zeile {}, und von einem Durchlauf zum nächsten ändert sich keine Variable.</translation>
    </message>
    <message>
        <source>Check the loop condition. Only the first passes are shown.</source>
        <translation>Die Bedingung der Schleife prüfen. Nur die ersten Durchläufe werden angezeigt.</translation>
    </message>
    <message>
        <source>{} repeats are more than the limit of {}; nothing is repeated here.</source>
        <translation>{} Wiederholungen sind mehr als die Grenze von {}; hier wird nichts wiederholt.</translation>
    </message>
    <message>
        <source>Check the number of repeats.</source>
        <translation>Die Zahl der Wiederholungen prüfen.</translation>
    </message>
    <message>
        <source>This block makes {} motions, more than the limit of {}; it is not executed.</source>
        <translation>Dieser Satz erzeugt {} Bewegungen, mehr als die Grenze von {}; er wird nicht ausgeführt.</translation>
    </message>
    <message>
        <source>Check the depth of the pecks, the step and the number of repeats.</source>
        <translation>Zustelltiefe je Bohrhub, Schritt und Zahl der Wiederholungen prüfen.</translation>
    </message>
    <message>
        <source>G10 with L{} is not supported.</source>
        <translation>G10 mit L{} wird nicht unterstützt.</translation>
    </message>
    <message>
        <source>Supported are L1, L2, L10, L11 and L20.</source>
        <translation>Unterstützt werden L1, L2, L10, L11 und L20.</translation>
    </message>
    <message>
        <source>No tool has the number {}.</source>
        <translation>Kein Werkzeug hat die Nummer {}.</translation>
    </message>
    <message>
        <source>Add it to the tool table, or correct the number.</source>
        <translation>In die Werkzeugtabelle aufnehmen oder die Nummer berichtigen.</translation>
    </message>
    <message>
        <source>{} and {} both use the axis words of this block.</source>
        <translation>{} und {} verwenden beide die Achswörter dieses Satzes.</translation>
    </message>
    <message>
        <source>Make two blocks; this block is skipped.</source>
        <translation>Auf zwei Sätze aufteilen; dieser Satz wird übersprungen.</translation>
    </message>
    <message>
        <source>G53 needs G0 or G1 in force.</source>
        <translation>Für G53 muss G0 oder G1 aktiv sein.</translation>
    </message>
    <message>
        <source>Write G53 G0 or G53 G1; this block is skipped.</source>
        <translation>G53 G0 oder G53 G1 schreiben; dieser Satz wird übersprungen.</translation>
    </message>
    <message>
        <source>The block has polar words (@ ^) and X or Y.</source>
        <translation>Der Satz hat Polarkoordinaten (@ ^) und X oder Y.</translation>
    </message>
    <message>
        <source>Keep one kind; this block is skipped.</source>
        <translation>Nur eine Art behalten; dieser Satz wird übersprungen.</translation>
    </message>
    <message>
        <source>{} counts from the current angle, and there is no angle at X0 Y0.</source>
        <translation>{} gilt ab dem aktuellen Winkel, und bei X0 Y0 gibt es keinen Winkel.</translation>
    </message>
    <message>
        <source>Give both @ and ^ in G90; this motion is skipped.</source>
        <translation>@ und ^ mit G90 angeben; diese Bewegung wird übersprungen.</translation>
    </message>
    <message>
        <source>G53 cannot be used with polar words.</source>
        <translation>G53 lässt sich nicht mit Polarkoordinaten (@ ^) verwenden.</translation>
    </message>
    <message>
        <source>Write X and Y; this block is skipped.</source>
        <translation>X und Y schreiben; dieser Satz wird übersprungen.</translation>
    </message>
    <message>
        <source>G53 cannot be used with incremental distances.</source>
        <translation>G53 lässt sich nicht mit inkrementaler Maßangabe verwenden.</translation>
    </message>
    <message>
        <source>Write G90 before it; this block is skipped.</source>
        <translation>G90 davor schreiben; dieser Satz wird übersprungen.</translation>
    </message>
    <message>
        <source>Machine zero is unknown, so {} has no position; motions are not simulated until the axis is positioned again.</source>
        <translation>Der Maschinennullpunkt ist unbekannt, daher hat {} keine Position; Bewegungen werden nicht simuliert, bis die Achse wieder positioniert ist.</translation>
    </message>
    <message>
        <source>Motions to reference positions are taken to lead away from the part.</source>
        <translation>Für Bewegungen zu Referenzpunkten wird angenommen, dass sie vom Werkstück wegführen.</translation>
    </message>
    <message>
        <source>The cycle {} needs the word {}.</source>
        <translation>Der Zyklus {} braucht das Wort {}.</translation>
    </message>
    <message>
        <source>The first block of a cycle must have it; this one drills nothing.</source>
        <translation>Der erste Satz eines Zyklus muss es haben; dieser bohrt nichts.</translation>
    </message>
    <message>
        <source>The cycle has no axis word.</source>
        <translation>Der Zyklus hat kein Achswort.</translation>
    </message>
    <message>
        <source>Program the position of the first hole.</source>
        <translation>Die Position der ersten Bohrung programmieren.</translation>
    </message>
    <message>
        <source>A cycle cannot be used with inverse time feed.</source>
        <translation>Ein Zyklus lässt sich nicht mit zeitreziprokem Vorschub verwenden.</translation>
    </message>
    <message>
        <source>Write G94 and a feed before it; the cycle drills nothing.</source>
        <translation>G94 und einen Vorschub davor schreiben; der Zyklus bohrt nichts.</translation>
    </message>
    <message>
        <source>With inverse time feed (G93) every cutting block needs an F word.</source>
        <translation>Mit zeitreziprokem Vorschub (G93) braucht jeder Satz mit einer Vorschubbewegung ein F-Wort.</translation>
    </message>
    <message>
        <source>Add F, one over the minutes that the motion takes.</source>
        <translation>F als Kehrwert der Dauer der Bewegung in Minuten ergänzen.</translation>
    </message>
    <message>
        <source>The feed counts per revolution (G95), but the spindle does not turn.</source>
        <translation>Der Vorschub gilt je Umdrehung (G95), aber die Spindel dreht sich nicht.</translation>
    </message>
    <message>
        <source>Switch the spindle on, or write G94 and a feed per minute.</source>
        <translation>Die Spindel einschalten oder G94 und einen Vorschub je Minute schreiben.</translation>
    </message>
    <message>
        <source>The R plane is below the hole bottom.</source>
        <translation>Die R-Ebene liegt unter dem Bohrungsgrund.</translation>
    </message>
    <message>
        <source>Check R and the depth; the cycle drills nothing.</source>
        <translation>R und die Tiefe prüfen; der Zyklus bohrt nichts.</translation>
    </message>
    <message>
        <source>The depth of a peck must be greater than 0.</source>
        <translation>Die Zustelltiefe je Bohrhub muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>Check the Q word; the cycle drills nothing.</source>
        <translation>Das Q-Wort prüfen; der Zyklus bohrt nichts.</translation>
    </message>
    <message>
        <source>The spindle must turn for this cycle: {}.</source>
        <translation>Für diesen Zyklus muss sich die Spindel drehen: {}.</translation>
    </message>
    <message>
        <source>Switch it on in a block before; the cycle drills nothing.</source>
        <translation>In einem Satz davor einschalten; der Zyklus bohrt nichts.</translation>
    </message>
    <message>
        <source>G87 cuts from below, which a z-map cannot represent.</source>
        <translation>G87 trägt von unten ab, was eine Z-Map nicht darstellen kann.</translation>
    </message>
    <message>
        <source>The motions are shown; what they cut from below is unverified.</source>
        <translation>Die Bewegungen werden gezeigt; was sie von unten abtragen, ist ungeprüft.</translation>
    </message>
    <message>
        <source>The position {} cannot be read while cutter compensation is on.</source>
        <translation>Die Position {} lässt sich nicht lesen, solange die Fräserradiuskorrektur aktiv ist.</translation>
    </message>
    <message>
        <source>Write G40 before it.</source>
        <translation>G40 davor schreiben.</translation>
    </message>
    <message>
        <source>Cutter compensation is on already.</source>
        <translation>Die Fräserradiuskorrektur ist schon aktiv.</translation>
    </message>
    <message>
        <source>Write G40 first; {} has no effect.</source>
        <translation>Zuerst G40 schreiben; {} hat keine Wirkung.</translation>
    </message>
    <message>
        <source>Cutter compensation works in the planes of G17 and G18 only.</source>
        <translation>Die Fräserradiuskorrektur wirkt nur in den Ebenen von G17 und G18.</translation>
    </message>
    <message>
        <source>Select the plane before; the code has no effect.</source>
        <translation>Die Ebene davor wählen; der Befehl hat keine Wirkung.</translation>
    </message>
    <message>
        <source>Cutter compensation in G18 under a rotation about Z is not supported.</source>
        <translation>Die Fräserradiuskorrektur in G18 bei einer Drehung um Z wird nicht unterstützt.</translation>
    </message>
    <message>
        <source>Remove the rotation from the work offset; the code has no effect.</source>
        <translation>Die Drehung aus der Nullpunktverschiebung entfernen; der Befehl hat keine Wirkung.</translation>
    </message>
    <message>
        <source>{} cannot be used while cutter compensation is on.</source>
        <translation>{} lässt sich nicht verwenden, solange die Fräserradiuskorrektur aktiv ist.</translation>
    </message>
    <message>
        <source>Write G40 before it; the code has no effect.</source>
        <translation>G40 davor schreiben; der Befehl hat keine Wirkung.</translation>
    </message>
    <message>
        <source>The diameter for {} is 0, so the tool moves on the programmed path.</source>
        <translation>Der Durchmesser für {} ist 0; das Werkzeug fährt daher auf der programmierten Bahn.</translation>
    </message>
    <message>
        <source>Check the tool table, if the path is not written for the centre of the tool.</source>
        <translation>Die Werkzeugtabelle prüfen, falls die Bahn nicht für den Werkzeugmittelpunkt programmiert ist.</translation>
    </message>
    <message>
        <source>No diameter is known for {}, so the tool moves on the programmed path.</source>
        <translation>Für {} ist kein Durchmesser bekannt; das Werkzeug fährt daher auf der programmierten Bahn.</translation>
    </message>
    <message>
        <source>Give the tools of the program.</source>
        <translation>Die Werkzeuge des Programms angeben.</translation>
    </message>
    <message>
        <source>The motion is not compensated: it leads from or to a place that is not known.</source>
        <translation>Die Bewegung wird nicht korrigiert: Ihr Start- oder Endpunkt ist unbekannt.</translation>
    </message>
    <message>
        <source>Position the axes of the plane before G41 or G42.</source>
        <translation>Die Achsen der Ebene vor G41 oder G42 positionieren.</translation>
    </message>
    <message>
        <source>The motion into cutter compensation is {} mm long, not longer than the tool&apos;s radius of {} mm.</source>
        <translation>Die Anfahrbewegung in die Fräserradiuskorrektur ist {} mm lang und damit nicht länger als der Werkzeugradius von {} mm.</translation>
    </message>
    <message>
        <source>Begin farther away; the motion is skipped.</source>
        <translation>Weiter entfernt beginnen; die Bewegung wird übersprungen.</translation>
    </message>
    <message>
        <source>The arc has a radius of {} mm, not larger than the tool&apos;s radius of {} mm.</source>
        <translation>Der Kreisbogen hat einen Radius von {} mm und ist damit nicht größer als der Werkzeugradius von {} mm.</translation>
    </message>
    <message>
        <source>Use a smaller tool; the motion is skipped.</source>
        <translation>Ein kleineres Werkzeug verwenden; die Bewegung wird übersprungen.</translation>
    </message>
    <message>
        <source>The tool with a radius of {} mm does not fit into this inside corner.</source>
        <translation>Das Werkzeug mit {} mm Radius passt nicht in diese Innenecke.</translation>
    </message>
    <message>
        <source>The tool with a radius of {} mm gouges between the inside corners of the motion of line {}.</source>
        <translation>Das Werkzeug mit {} mm Radius verletzt die Kontur zwischen den Innenecken der Bewegung von Zeile {}.</translation>
    </message>
    <message>
        <source>Use a smaller tool, or remove the short motion.</source>
        <translation>Ein kleineres Werkzeug verwenden oder die kurze Bewegung entfernen.</translation>
    </message>
    <message>
        <source>The tool with a radius of {} mm goes backward in the motion of line {} and gouges; LinuxCNC does not notice.</source>
        <translation>Das Werkzeug mit {} mm Radius fährt in der Bewegung von Zeile {} rückwärts und verletzt die Kontur; LinuxCNC bemerkt das nicht.</translation>
    </message>
    <message>
        <source>A stop before this inside corner makes the tool overrun it and gouge.</source>
        <translation>Ein Halt vor dieser Innenecke lässt das Werkzeug zu weit fahren und die Kontur verletzen.</translation>
    </message>
    <message>
        <source>Stop elsewhere: the corner is known only when the motion to it is done.</source>
        <translation>An anderer Stelle halten: Die Ecke ist erst bekannt, wenn die Bewegung zu ihr ausgeführt ist.</translation>
    </message>
    <message>
        <source>The first motion after G40 must be straight.</source>
        <translation>Die erste Bewegung nach G40 muss eine Gerade sein.</translation>
    </message>
    <message>
        <source>Lead out with G0 or G1; the arc is skipped.</source>
        <translation>Mit G0 oder G1 abfahren; der Kreisbogen wird übersprungen.</translation>
    </message>
    <message>
        <source>Cutter compensation is still on at the end of the program.</source>
        <translation>Die Fräserradiuskorrektur ist am Programmende noch aktiv.</translation>
    </message>
    <message>
        <source>Lead out with G40.</source>
        <translation>Mit G40 abfahren.</translation>
    </message>
    <message>
        <source>M72 restores a modal state, but none is saved at this level of calls.</source>
        <translation>M72 stellt einen modalen Zustand wieder her, aber in dieser Aufrufebene ist keiner gesichert.</translation>
    </message>
    <message>
        <source>Write M70 or M73 before it, in the same subprogram.</source>
        <translation>M70 oder M73 davor schreiben, im selben Unterprogramm.</translation>
    </message>
    <message>
        <source>M72 is not alone in its block.</source>
        <translation>M72 steht nicht allein im Satz.</translation>
    </message>
    <message>
        <source>LinuxCNC ignores the rest of the block after restoring; give M72 a block of its own.</source>
        <translation>LinuxCNC ignoriert nach dem Wiederherstellen den Rest des Satzes; M72 in einen eigenen Satz schreiben.</translation>
    </message>
    <message>
        <source>G7 makes X a diameter, as on a lathe: LinuxCNC would halve every X.</source>
        <translation>G7 macht X zum Durchmesser, wie auf einer Drehmaschine: LinuxCNC würde jedes X halbieren.</translation>
    </message>
    <message>
        <source>Remove it, or write G8; X is shown as a radius.</source>
        <translation>Entfernen oder G8 schreiben; X wird als Radius gezeigt.</translation>
    </message>
    <message>
        <source>With G96 the spindle follows X; it is taken to turn at its limit D, {} rpm.</source>
        <translation>Mit G96 folgt die Spindel X; angenommen wird ihre Grenze D, {} 1/min.</translation>
    </message>
    <message>
        <source>X is not a diameter on a mill: write G97 and a speed.</source>
        <translation>X ist auf einer Fräsmaschine kein Durchmesser: G97 und eine Drehzahl schreiben.</translation>
    </message>
    <message>
        <source>Spindle speed is unknown, because G96 has no D.</source>
        <translation>Die Spindeldrehzahl ist unbekannt, weil G96 kein D hat.</translation>
    </message>
    <message>
        <source>Write G97 and a speed, or a limit D.</source>
        <translation>G97 und eine Drehzahl oder eine Grenze D schreiben.</translation>
    </message>
    <message>
        <source>M66 has P and E: a digital and an analog input.</source>
        <translation>M66 hat P und E: einen digitalen und einen analogen Eingang.</translation>
    </message>
    <message>
        <source>Keep one of them.</source>
        <translation>Eines davon behalten.</translation>
    </message>
    <message>
        <source>M66 cannot wait for an analog input.</source>
        <translation>M66 kann nicht auf einen analogen Eingang warten.</translation>
    </message>
    <message>
        <source>Remove L, or write L0.</source>
        <translation>L entfernen oder L0 schreiben.</translation>
    </message>
    <message>
        <source>Input value of M66 unknown; #5399 is assumed to be {}.</source>
        <translation>Eingangswert von M66 unbekannt; für #5399 wird {} angenommen.</translation>
    </message>
    <message>
        <source>What follows is verified as long as it does not read #5399.</source>
        <translation>Was folgt, ist geprüft, solange es #5399 nicht liest.</translation>
    </message>
    <message>
        <source>This line reads #5399, which holds an input of the machine.</source>
        <translation>Diese Zeile liest #5399 und damit einen Eingang der Maschine.</translation>
    </message>
    <message>
        <source>Results that depend on it are unverified.</source>
        <translation>Davon abhängige Ergebnisse sind ungeprüft.</translation>
    </message>
    <message>
        <source>The pitch K must be greater than 0.</source>
        <translation>Die Steigung K muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>Check the K word; nothing moves.</source>
        <translation>Das K-Wort prüfen; nichts bewegt sich.</translation>
    </message>
    <message>
        <source>{} moves in step with the spindle and takes no F.</source>
        <translation>{} bewegt sich synchron zur Spindel und erlaubt kein F.</translation>
    </message>
    <message>
        <source>Remove F; the feed is the pitch K times the speed of the spindle.</source>
        <translation>F entfernen; der Vorschub ist Steigung K mal Spindeldrehzahl.</translation>
    </message>
    <message>
        <source>{} moves in step with the spindle, which does not turn.</source>
        <translation>{} bewegt sich synchron zur Spindel, aber sie dreht nicht.</translation>
    </message>
    <message>
        <source>Write S and M3 or M4 in a block before.</source>
        <translation>S und M3 oder M4 in einen Satz davor schreiben.</translation>
    </message>
    <message>
        <source>Probing with a feed per revolution (G95) is not possible.</source>
        <translation>Antasten mit Vorschub je Umdrehung (G95) ist nicht möglich.</translation>
    </message>
    <message>
        <source>Write G94 and a feed per minute.</source>
        <translation>G94 und einen Vorschub je Minute schreiben.</translation>
    </message>
    <message>
        <source>The probing motion ends where it begins.</source>
        <translation>Die Antastbewegung endet, wo sie beginnt.</translation>
    </message>
    <message>
        <source>Check the axis words.</source>
        <translation>Die Achswörter prüfen.</translation>
    </message>
    <message>
        <source>The position where the probe meets the part is unknown.</source>
        <translation>Die Position, an der der Taster das Werkstück berührt, ist unbekannt.</translation>
    </message>
    <message>
        <source>Write G17 before it.</source>
        <translation>G17 davor schreiben.</translation>
    </message>
    <message>
        <source>G5 without I and J continues a G5, but the motion before it is not a G5.</source>
        <translation>G5 ohne I und J setzt ein G5 fort, aber die Bewegung davor ist kein G5.</translation>
    </message>
    <message>
        <source>Program I and J; LinuxCNC would use values left by an earlier block.</source>
        <translation>I und J programmieren; LinuxCNC würde Werte aus einem früheren Satz verwenden.</translation>
    </message>
    <message>
        <source>The spline needs more than {} straight motions.</source>
        <translation>Der Spline braucht mehr als {} gerade Bewegungen.</translation>
    </message>
    <message>
        <source>Check its points.</source>
        <translation>Seine Punkte prüfen.</translation>
    </message>
    <message>
        <source>A control point needs both X and Y.</source>
        <translation>Ein Kontrollpunkt braucht X und Y.</translation>
    </message>
    <message>
        <source>Add the missing word; the point is ignored.</source>
        <translation>Das fehlende Wort ergänzen; der Punkt wird ignoriert.</translation>
    </message>
    <message>
        <source>A control point needs a weight P greater than 0.</source>
        <translation>Ein Kontrollpunkt braucht ein Gewicht P größer als 0.</translation>
    </message>
    <message>
        <source>Write P1 for an ordinary point; the point is ignored.</source>
        <translation>Für einen gewöhnlichen Punkt P1 schreiben; der Punkt wird ignoriert.</translation>
    </message>
    <message>
        <source>P without X and Y is the weight of the first control point only.</source>
        <translation>P ohne X und Y ist nur das Gewicht des ersten Kontrollpunkts.</translation>
    </message>
    <message>
        <source>Close the NURBS block with G5.3 before the next one begins.</source>
        <translation>Den NURBS-Block mit G5.3 schließen, bevor der nächste beginnt.</translation>
    </message>
    <message>
        <source>The NURBS block has {} control points, fewer than its order {}.</source>
        <translation>Der NURBS-Block hat {} Kontrollpunkte, weniger als seine Ordnung {}.</translation>
    </message>
    <message>
        <source>Add points, or lower the order L.</source>
        <translation>Punkte ergänzen oder die Ordnung L senken.</translation>
    </message>
    <message>
        <source>G5.3 closes a NURBS block, but none is open.</source>
        <translation>G5.3 schließt einen NURBS-Block, aber keiner ist offen.</translation>
    </message>
    <message>
        <source>Start it with G5.2; other motions in between end it.</source>
        <translation>Mit G5.2 beginnen; andere Bewegungen dazwischen beenden den NURBS-Block.</translation>
    </message>
    <message>
        <source>A NURBS block was started by G5.2 but not closed: it makes no motion.</source>
        <translation>Ein NURBS-Block wurde mit G5.2 begonnen, aber nicht geschlossen: Er erzeugt keine Bewegung.</translation>
    </message>
    <message>
        <source>Write G5.3 after its last control point.</source>
        <translation>G5.3 nach dem letzten Kontrollpunkt schreiben.</translation>
    </message>
    <message>
        <source>high-speed machining</source>
        <translation>Hochgeschwindigkeitsbearbeitung</translation>
    </message>
    <message>
        <source>look-ahead contour control</source>
        <translation>vorausschauende Bahnsteuerung</translation>
    </message>
    <message>
        <source>hypothetical axis interpolation</source>
        <translation>Interpolation mit hypothetischer Achse</translation>
    </message>
    <message>
        <source>look-ahead control</source>
        <translation>vorausschauende Steuerung</translation>
    </message>
    <message>
        <source>set data</source>
        <translation>Daten setzen</translation>
    </message>
    <message>
        <source>end of set data</source>
        <translation>Ende des Datensetzens</translation>
    </message>
    <message>
        <source>polar coordinate interpolation</source>
        <translation>Polarkoordinaten-Interpolation</translation>
    </message>
    <message>
        <source>polar coordinate interpolation off</source>
        <translation>Polarkoordinaten-Interpolation aus</translation>
    </message>
    <message>
        <source>stored stroke check on</source>
        <translation>Verfahrbereichsüberwachung ein</translation>
    </message>
    <message>
        <source>stored stroke check off</source>
        <translation>Verfahrbereichsüberwachung aus</translation>
    </message>
    <message>
        <source>spindle speed watch off</source>
        <translation>Spindeldrehzahl-Überwachung aus</translation>
    </message>
    <message>
        <source>spindle speed watch on</source>
        <translation>Spindeldrehzahl-Überwachung ein</translation>
    </message>
    <message>
        <source>check of the reference position</source>
        <translation>Referenzpunkt prüfen</translation>
    </message>
    <message>
        <source>return from reference position</source>
        <translation>Rückkehr vom Referenzpunkt</translation>
    </message>
    <message>
        <source>thread cutting</source>
        <translation>Gewindeschneiden</translation>
    </message>
    <message>
        <source>automatic tool length measurement</source>
        <translation>automatische Werkzeuglängenmessung</translation>
    </message>
    <message>
        <source>lengthen the motion by the offset</source>
        <translation>Weg um den Korrekturwert verlängern</translation>
    </message>
    <message>
        <source>shorten the motion by the offset</source>
        <translation>Weg um den Korrekturwert verkürzen</translation>
    </message>
    <message>
        <source>lengthen the motion by twice the offset</source>
        <translation>Weg um den doppelten Korrekturwert verlängern</translation>
    </message>
    <message>
        <source>shorten the motion by twice the offset</source>
        <translation>Weg um den doppelten Korrekturwert verkürzen</translation>
    </message>
    <message>
        <source>approach from one side</source>
        <translation>einseitiges Positionieren</translation>
    </message>
    <message>
        <source>automatic corner override</source>
        <translation>automatischer Ecken-Override</translation>
    </message>
    <message>
        <source>tapping mode</source>
        <translation>Gewindebohrbetrieb</translation>
    </message>
    <message>
        <source>cutting mode</source>
        <translation>Schneidbetrieb</translation>
    </message>
    <message>
        <source>macro call by every block</source>
        <translation>Makroaufruf in jedem Satz</translation>
    </message>
    <message>
        <source>tilted working plane</source>
        <translation>geschwenkte Bearbeitungsebene</translation>
    </message>
    <message>
        <source>fine boring cycle</source>
        <translation>Feinbohrzyklus</translation>
    </message>
    <message>
        <source>boring cycle, stop and manual out</source>
        <translation>Ausdrehzyklus, Halt und Rückzug von Hand</translation>
    </message>
    <message>
        <source>boring cycle with dwell, feed out</source>
        <translation>Ausdrehzyklus mit Verweilzeit, Rückzug im Vorschub</translation>
    </message>
    <message>
        <source>set the work coordinates</source>
        <translation>Werkstückkoordinaten setzen</translation>
    </message>
    <message>
        <source>preset the work coordinates</source>
        <translation>Werkstückkoordinaten zurücksetzen</translation>
    </message>
    <message>
        <source>call of a program in external memory</source>
        <translation>Aufruf eines Programms im externen Speicher</translation>
    </message>
    <message>
        <source>There is no parameter with the number {}.</source>
        <translation>Es gibt keinen Parameter mit der Nummer {}.</translation>
    </message>
    <message>
        <source>{} needs two arguments.</source>
        <translation>{} braucht zwei Argumente.</translation>
    </message>
    <message>
        <source>Write ATAN[y]/[x].</source>
        <translation>ATAN[y]/[x] schreiben.</translation>
    </message>
    <message>
        <source>The jump target is not a whole number from 0 to 99999999.</source>
        <translation>Das Sprungziel ist keine ganze Zahl von 0 bis 99999999.</translation>
    </message>
    <message>
        <source>Jump to a block number that follows an N.</source>
        <translation>Zu einer Satznummer springen, die nach einem N steht.</translation>
    </message>
    <message>
        <source>There is no block N{} in this program.</source>
        <translation>In diesem Programm gibt es keinen Satz N{}.</translation>
    </message>
    <message>
        <source>Check the number; a jump does not leave its program.</source>
        <translation>Die Nummer prüfen; ein Sprung verlässt sein Programm nicht.</translation>
    </message>
    <message>
        <source>The statement is not complete.</source>
        <translation>Die Anweisung ist nicht vollständig.</translation>
    </message>
    <message>
        <source>Write IF [#1 GT 2] GOTO 10, IF [#1 GT 2] THEN #3=4, or WHILE [#1 GT 2] DO 1.</source>
        <translation>IF [#1 GT 2] GOTO 10, IF [#1 GT 2] THEN #3=4 oder WHILE [#1 GT 2] DO 1 schreiben.</translation>
    </message>
    <message>
        <source>The statement does not begin the block.</source>
        <translation>Die Anweisung steht nicht am Anfang des Satzes.</translation>
    </message>
    <message>
        <source>The loop has no matching {}.</source>
        <translation>Zur Schleife fehlt das zugehörige {}.</translation>
    </message>
    <message>
        <source>DO 1 needs END 1 in the same program; loops do not cross each other.</source>
        <translation>DO 1 braucht END 1 im selben Programm; Schleifen überschneiden sich nicht.</translation>
    </message>
    <message>
        <source>The value of {} is kept by the machine; it is assumed to be 0.</source>
        <translation>Den Wert von {} speichert die Maschine; angenommen wird 0.</translation>
    </message>
    <message>
        <source>Check the program with other values where a decision depends on it.</source>
        <translation>Das Programm mit anderen Werten prüfen, wenn eine Entscheidung davon abhängt.</translation>
    </message>
    <message>
        <source>The value of {} depends on the machine that runs the program.</source>
        <translation>Der Wert von {} hängt von der Maschine ab, die das Programm ausführt.</translation>
    </message>
    <message>
        <source>What follows from it is unverified.</source>
        <translation>Was daraus folgt, ist ungeprüft.</translation>
    </message>
    <message>
        <source>The position {} is not known here.</source>
        <translation>Die Position {} ist hier nicht bekannt.</translation>
    </message>
    <message>
        <source>Position the axis first, or enter a start position in the setup.</source>
        <translation>Zuerst die Achse positionieren oder in der Aufspannung eine Startposition eingeben.</translation>
    </message>
    <message>
        <source>The program stops itself with alarm {}.</source>
        <translation>Das Programm hält mit Alarm {} an.</translation>
    </message>
    <message>
        <source>The comment beside it says why; the program ends here.</source>
        <translation>Den Grund nennt der Kommentar daneben; das Programm endet hier.</translation>
    </message>
    <message>
        <source>Dialect detected: {} (from {}).</source>
        <translation>Dialekt erkannt: {} (aus {}).</translation>
    </message>
    <message>
        <source>Choose the dialect yourself if that is wrong.</source>
        <translation>Den Dialekt selbst wählen, falls das nicht stimmt.</translation>
    </message>
    <message>
        <source>The text before the first &quot;%&quot; is not run.</source>
        <translation>Der Text vor dem ersten „%“ wird nicht ausgeführt.</translation>
    </message>
    <message>
        <source>{} and {} cannot be used in one block; the last one counts.</source>
        <translation>{} und {} sind in einem Satz nicht zusammen zulässig; der letzte Befehl gilt.</translation>
    </message>
    <message>
        <source>Some controls give an alarm instead; keep one of them.</source>
        <translation>Manche Steuerungen geben stattdessen einen Alarm aus; nur einen davon behalten.</translation>
    </message>
    <message>
        <source>Duplicate {} word; the last one counts.</source>
        <translation>Doppeltes Wort {}; das letzte gilt.</translation>
    </message>
    <message>
        <source>No code of this block uses the word {}; it is ignored.</source>
        <translation>Kein Befehl dieses Satzes verwendet das Wort {}; es wird ignoriert.</translation>
    </message>
    <message>
        <source>Remove it, or add the code that it belongs to.</source>
        <translation>Entfernen oder den zugehörigen Befehl ergänzen.</translation>
    </message>
    <message>
        <source>After G80, {} moves without a motion code, at rapid.</source>
        <translation>Nach G80 bewegt sich {} ohne Bewegungsbefehl, im Eilgang.</translation>
    </message>
    <message>
        <source>Write G0 or G1 into the block; controls differ here.</source>
        <translation>G0 oder G1 in den Satz schreiben; Steuerungen verhalten sich hier verschieden.</translation>
    </message>
    <message>
        <source>{} has no decimal point: the control reads it as {}; one with calculator-type input as {}.</source>
        <translation>{} hat keinen Dezimalpunkt: Die Steuerung liest es als {}, eine mit Taschenrechnereingabe als {}.</translation>
    </message>
    <message>
        <source>Write the decimal point.</source>
        <translation>Den Dezimalpunkt schreiben.</translation>
    </message>
    <message>
        <source>The block has more than {} M words.</source>
        <translation>Der Satz hat mehr als {} M-Wörter.</translation>
    </message>
    <message>
        <source>The feed rate is 0.</source>
        <translation>Der Vorschub ist 0.</translation>
    </message>
    <message>
        <source>Give F a value above 0.</source>
        <translation>Für F einen Wert über 0 angeben.</translation>
    </message>
    <message>
        <source>T{} cuts without its own tool length offset.</source>
        <translation>T{} fräst ohne eigene Werkzeuglängenkorrektur.</translation>
    </message>
    <message>
        <source>Write G43 after the tool change: the offset of the previous tool is still active.</source>
        <translation>G43 nach dem Werkzeugwechsel schreiben: Die Korrektur des vorigen Werkzeugs ist noch aktiv.</translation>
    </message>
    <message>
        <source>The program cuts before it selects a work offset.</source>
        <translation>Das Programm fräst, bevor es eine Nullpunktverschiebung wählt.</translation>
    </message>
    <message>
        <source>Write G54, or the work offset of the part.</source>
        <translation>G54 oder die Nullpunktverschiebung des Werkstücks schreiben.</translation>
    </message>
    <message>
        <source>The tool length offset H{} does not match tool {}.</source>
        <translation>Die Werkzeuglängenkorrektur H{} passt nicht zu Werkzeug {}.</translation>
    </message>
    <message>
        <source>Use the tool number, unless another offset is intended.</source>
        <translation>Die Werkzeugnummer verwenden, falls keine andere Korrektur gewollt ist.</translation>
    </message>
    <message>
        <source>{} has no D word.</source>
        <translation>{} hat kein D-Wort.</translation>
    </message>
    <message>
        <source>Write the offset number: the last one used is active.</source>
        <translation>Die Korrekturnummer schreiben: Aktiv ist die zuletzt verwendete.</translation>
    </message>
    <message>
        <source>Cutter compensation begins on an arc.</source>
        <translation>Die Fräserradiuskorrektur beginnt auf einem Kreisbogen.</translation>
    </message>
    <message>
        <source>Lead in with a straight motion; many controls give an alarm here.</source>
        <translation>Mit einer Geraden anfahren; viele Steuerungen geben hier einen Alarm aus.</translation>
    </message>
    <message>
        <source>{} changes the unit in the middle of the program.</source>
        <translation>{} wechselt mitten im Programm die Maßeinheit.</translation>
    </message>
    <message>
        <source>Keep to one unit; active lengths keep the old one.</source>
        <translation>Bei einer Einheit bleiben; aktive Längen behalten die alte.</translation>
    </message>
    <message>
        <source>Still active here: {}.</source>
        <translation>Hier noch aktiv: {}.</translation>
    </message>
    <message>
        <source>End it before the tool change and before the end of the program.</source>
        <translation>Vor dem Werkzeugwechsel und vor dem Programmende beenden.</translation>
    </message>
    <message>
        <source>The tool is changed at Z{}, not above Z{}, where it cut.</source>
        <translation>Das Werkzeug wird bei Z{} gewechselt, nicht oberhalb von Z{}, wo es gefräst hat.</translation>
    </message>
    <message>
        <source>Retract first.</source>
        <translation>Zuerst freifahren.</translation>
    </message>
    <message>
        <source>The tool is changed while the spindle turns.</source>
        <translation>Das Werkzeug wird bei drehender Spindel gewechselt.</translation>
    </message>
    <message>
        <source>Write M5 before it; not every machine stops the spindle by itself.</source>
        <translation>M5 davor schreiben; nicht jede Maschine hält die Spindel selbst an.</translation>
    </message>
    <message>
        <source>The arc by its radius is nearly a half circle, {} degrees.</source>
        <translation>Der über den Radius angegebene Kreisbogen ist fast ein Halbkreis, {} Grad.</translation>
    </message>
    <message>
        <source>Program the centre with I, J and K: here the last digit of R moves it far.</source>
        <translation>Den Mittelpunkt mit I, J und K programmieren: Hier verschiebt ihn die letzte Ziffer von R weit.</translation>
    </message>
    <message>
        <source>in its block only</source>
        <translation>nur in seinem Satz</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>distance mode</source>
        <translation>Maßangabe</translation>
    </message>
    <message>
        <source>arc distance mode</source>
        <translation>Maßangabe der Kreismittelpunkte</translation>
    </message>
    <message>
        <source>feed mode</source>
        <translation>Vorschubart</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Maßeinheit</translation>
    </message>
    <message>
        <source>cutter compensation</source>
        <translation>Fräserradiuskorrektur</translation>
    </message>
    <message>
        <source>tool length</source>
        <translation>Werkzeuglänge</translation>
    </message>
    <message>
        <source>canned-cycle return</source>
        <translation>Rückzug der Festzyklen</translation>
    </message>
    <message>
        <source>work offset</source>
        <translation>Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>path control</source>
        <translation>Bahnsteuerung</translation>
    </message>
    <message>
        <source>spindle mode</source>
        <translation>Spindelbetriebsart</translation>
    </message>
    <message>
        <source>polar coordinates</source>
        <translation>Polarkoordinaten</translation>
    </message>
    <message>
        <source>look-ahead</source>
        <translation>Look-ahead</translation>
    </message>
    <message>
        <source>diameter mode</source>
        <translation>Durchmesserprogrammierung</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>Halt</translation>
    </message>
    <message>
        <source>inputs and outputs</source>
        <translation>Ein- und Ausgänge</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>coolant</source>
        <translation>Kühlmittel</translation>
    </message>
    <message>
        <source>overrides</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>saved modal state</source>
        <translation>gesicherter modaler Zustand</translation>
    </message>
    <message>
        <source>subprogram</source>
        <translation>Unterprogramm</translation>
    </message>
    <message>
        <source>tapping</source>
        <translation>Gewindebohren</translation>
    </message>
    <message>
        <source>Repeated lines gave {} messages; interpretation ends here.</source>
        <translation>Wiederholte Zeilen ergaben {} Meldungen; die Interpretation endet hier.</translation>
    </message>
    <message>
        <source>Correct what is wrong in the loop.</source>
        <translation>Den Fehler in der Schleife berichtigen.</translation>
    </message>
    <message>
        <source>engraving of text</source>
        <translation>Text gravieren</translation>
    </message>
    <message>
        <source>bolt hole circle</source>
        <translation>Lochkreis</translation>
    </message>
    <message>
        <source>bolt hole arc</source>
        <translation>Lochkreisbogen</translation>
    </message>
    <message>
        <source>bolt holes along a line</source>
        <translation>Lochreihe</translation>
    </message>
    <message>
        <source>boring cycle, dwell, stop and manual out</source>
        <translation>Ausdrehzyklus mit Verweilzeit, Halt und Rückzug von Hand</translation>
    </message>
    <message>
        <source>limit of the look-ahead</source>
        <translation>Begrenzung des Look-ahead</translation>
    </message>
    <message>
        <source>cylindrical mapping</source>
        <translation>Zylindermantel-Abbildung</translation>
    </message>
    <message>
        <source>pocket of any shape</source>
        <translation>Tasche beliebiger Form</translation>
    </message>
    <message>
        <source>smoothness of the path</source>
        <translation>Glättung der Bahn</translation>
    </message>
    <message>
        <source>The boring bar moves aside before it leaves the bore, but is cut as a full cylinder.</source>
        <translation>Die Bohrstange fährt vor dem Verlassen der Bohrung zur Seite, wird aber als voller Zylinder simuliert.</translation>
    </message>
    <message>
        <source>Contacts shown during the retract are unverified.</source>
        <translation>Beim Rückzug gezeigte Berührungen sind ungeprüft.</translation>
    </message>
    <message>
        <source>The operator retracts the tool from the hole by hand.</source>
        <translation>Der Bediener zieht das Werkzeug von Hand aus der Bohrung zurück.</translation>
    </message>
    <message>
        <source>A straight retract is shown; results after this block are unverified.</source>
        <translation>Gezeigt wird ein gerader Rückzug; die Ergebnisse nach diesem Satz sind ungeprüft.</translation>
    </message>
    <message>
        <source>Back boring feeds up from R, but the depth is not above R.</source>
        <translation>Rückwärtssenken fährt im Vorschub von R nach oben, aber die Tiefe liegt nicht über R.</translation>
    </message>
    <message>
        <source>Check R and the depth; the cycle bores nothing.</source>
        <translation>R und die Tiefe prüfen; der Zyklus bohrt nichts.</translation>
    </message>
    <message>
        <source>{} cannot be used with G99; it returns to the initial level.</source>
        <translation>{} ist mit G99 nicht zulässig; der Zyklus kehrt auf die Ausgangsebene zurück.</translation>
    </message>
    <message>
        <source>Write G98 before it.</source>
        <translation>G98 davor schreiben.</translation>
    </message>
    <message>
        <source>G98 returns to the initial level, which is unknown; a return to R is shown.</source>
        <translation>G98 kehrt auf die Ausgangsebene zurück, die unbekannt ist; gezeigt wird die Rückkehr auf R.</translation>
    </message>
    <message>
        <source>Position the axis before the cycle.</source>
        <translation>Die Achse vor dem Zyklus positionieren.</translation>
    </message>
    <message>
        <source>{} has no Q: the hole is drilled in one go.</source>
        <translation>{} hat kein Q: Die Bohrung wird in einem Zug gebohrt.</translation>
    </message>
    <message>
        <source>Newer controls stop with an alarm instead; give the depth of a peck.</source>
        <translation>Neuere Steuerungen halten stattdessen mit einem Alarm an; die Zustelltiefe je Bohrhub angeben.</translation>
    </message>
    <message>
        <source>The spindle is stopped and M29 (rigid tapping) is not active.</source>
        <translation>Die Spindel steht, und M29 (Gewindebohren ohne Ausgleichsfutter) ist nicht aktiv.</translation>
    </message>
    <message>
        <source>Some machines tap rigidly without M29, as shown here; write M29 before the cycle.</source>
        <translation>Manche Maschinen bohren Gewinde, wie hier gezeigt, auch ohne M29 ohne Ausgleichsfutter; M29 vor den Zyklus schreiben.</translation>
    </message>
    <message>
        <source>With 0 repeats the cycle is only stored; the {} of this block is not moved to.</source>
        <translation>Mit 0 Wiederholungen wird der Zyklus nur gespeichert; {} dieses Satzes wird nicht angefahren.</translation>
    </message>
    <message>
        <source>Some controls move there; program the position in another block.</source>
        <translation>Manche Steuerungen fahren dorthin; die Position in einem anderen Satz programmieren.</translation>
    </message>
    <message>
        <source>{} drills with the active canned cycle, but no cycle is active.</source>
        <translation>{} bohrt mit dem aktiven Festzyklus, aber es ist keiner aktiv.</translation>
    </message>
    <message>
        <source>Write the cycle with L0 in a block before; the pattern drills nothing.</source>
        <translation>Den Zyklus mit L0 in einen Satz davor schreiben; das Lochbild bohrt nichts.</translation>
    </message>
    <message>
        <source>The first hole of G72 is assumed to be at the current position.</source>
        <translation>Für die erste Bohrung von G72 wird die aktuelle Position angenommen.</translation>
    </message>
    <message>
        <source>Check it against the manual of the control.</source>
        <translation>Im Handbuch der Steuerung prüfen.</translation>
    </message>
    <message>
        <source>How the control moves from circle to circle of the pocket is not documented; half circles are shown.</source>
        <translation>Wie die Steuerung von Kreis zu Kreis der Tasche fährt, ist nicht dokumentiert; gezeigt werden Halbkreise.</translation>
    </message>
    <message>
        <source>The finished pocket is the same.</source>
        <translation>Die fertige Tasche ist dieselbe.</translation>
    </message>
    <message>
        <source>No pocket leads from radius {} mm to {} mm with a tool of radius {} mm.</source>
        <translation>Von Radius {} mm bis {} mm gibt es mit einem Werkzeug von Radius {} mm keine Tasche.</translation>
    </message>
    <message>
        <source>Check I, K and D; the pocket is not milled.</source>
        <translation>I, K und D prüfen; die Tasche wird nicht gefräst.</translation>
    </message>
    <message>
        <source>G29 returns through the intermediate point of G28, which is unknown for {}.</source>
        <translation>G29 kehrt über den Zwischenpunkt von G28 zurück, der für {} nicht bekannt ist.</translation>
    </message>
    <message>
        <source>Position the axis before G28 and program it there.</source>
        <translation>Die Achse vor G28 positionieren und in G28 programmieren.</translation>
    </message>
    <message>
        <source>G60 overshoots by a distance set in the machine; it is shown without the overshoot.</source>
        <translation>G60 überfährt das Ziel um eine in der Maschine eingestellte Strecke; gezeigt wird es ohne das Überfahren.</translation>
    </message>
    <message>
        <source>Make sure that there is room beyond the target.</source>
        <translation>Prüfen, ob hinter dem Ziel genug Platz ist.</translation>
    </message>
    <message>
        <source>The skip motion is shown to its end; where a signal stops it is unknown.</source>
        <translation>Die Bewegung mit Restweglöschen wird bis zu ihrem Ende gezeigt; wo ein Signal sie anhält, ist unbekannt.</translation>
    </message>
    <message>
        <source>The arc has both a centre and a radius; the radius counts.</source>
        <translation>Der Kreisbogen hat sowohl einen Mittelpunkt als auch einen Radius; der Radius gilt.</translation>
    </message>
    <message>
        <source>Other controls refuse this; keep one.</source>
        <translation>Andere Steuerungen lehnen das ab; nur eines behalten.</translation>
    </message>
    <message>
        <source>The arc with R ends where it begins, so that nothing moves.</source>
        <translation>Der Kreisbogen mit R endet, wo er beginnt, sodass sich nichts bewegt.</translation>
    </message>
    <message>
        <source>The arc has neither a centre nor a radius: the control moves straight, or stops with an alarm.</source>
        <translation>Der Kreisbogen hat weder Mittelpunkt noch Radius: Die Steuerung fährt gerade oder hält mit einem Alarm an.</translation>
    </message>
    <message>
        <source>Give the centre with I, J or K, or the radius with R.</source>
        <translation>Den Mittelpunkt mit I, J oder K oder den Radius mit R angeben.</translation>
    </message>
    <message>
        <source>Program position</source>
        <translation>Programmposition</translation>
    </message>
    <message>
        <source>Work offset</source>
        <translation>Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>Shift by G52 and G92</source>
        <translation>Verschiebung durch G52 und G92</translation>
    </message>
    <message>
        <source>Tool length offset</source>
        <translation>Werkzeuglängenkorrektur</translation>
    </message>
    <message>
        <source>Feed rate</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>Tool in the spindle</source>
        <translation>Werkzeug in der Spindel</translation>
    </message>
    <message>
        <source>Next tool</source>
        <translation>Nächstes Werkzeug</translation>
    </message>
    <message>
        <source>G68 rotates in another plane than that of the arc, which then is in no plane of the machine.</source>
        <translation>G68 dreht in einer anderen Ebene als der des Kreisbogens, der damit in keiner Ebene der Maschine liegt.</translation>
    </message>
    <message>
        <source>Keep the plane that was active at G68.</source>
        <translation>Die bei G68 aktive Ebene beibehalten.</translation>
    </message>
    <message>
        <source>Different scale factors along the axes of its plane turn this arc into an ellipse.</source>
        <translation>Verschiedene Skalierungsfaktoren entlang der Achsen seiner Ebene machen diesen Kreisbogen zur Ellipse.</translation>
    </message>
    <message>
        <source>Use one factor for both axes, or let the CAM system output lines.</source>
        <translation>Einen Faktor für beide Achsen verwenden oder das CAM-System Geraden ausgeben lassen.</translation>
    </message>
    <message>
        <source>The scale factor of {} must not be 0.</source>
        <translation>Der Skalierungsfaktor von {} darf nicht 0 sein.</translation>
    </message>
    <message>
        <source>Check the number; the code has no effect.</source>
        <translation>Die Zahl prüfen; der Befehl hat keine Wirkung.</translation>
    </message>
    <message>
        <source>{} is inside {}: the control needs mirror image, scaling and rotation started in this order and cancelled in the opposite one.</source>
        <translation>{} liegt innerhalb von {}: Die Steuerung verlangt, dass Spiegelung, Skalierung und Drehung in dieser Reihenfolge begonnen und in umgekehrter Reihenfolge aufgehoben werden.</translation>
    </message>
    <message>
        <source>Cancel the inner one first.</source>
        <translation>Zuerst den inneren Befehl aufheben.</translation>
    </message>
    <message>
        <source>The first motion after {} does not program both axes of the rotation; controls differ here.</source>
        <translation>Die erste Bewegung nach {} programmiert nicht beide Achsen der Drehung; Steuerungen verhalten sich hier verschieden.</translation>
    </message>
    <message>
        <source>Position both axes in G90 after it.</source>
        <translation>Danach beide Achsen mit G90 positionieren.</translation>
    </message>
    <message>
        <source>G53 is ignored with incremental distances; nothing moves.</source>
        <translation>G53 wird bei inkrementaler Maßangabe ignoriert; nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Write G90 before it.</source>
        <translation>G90 davor schreiben.</translation>
    </message>
    <message>
        <source>Supported are L1, L2, L10 to L13 and L20.</source>
        <translation>Unterstützt werden L1, L2, L10 bis L13 und L20.</translation>
    </message>
    <message>
        <source>G10 with L{} begins to set data of the control; the blocks up to G11 are skipped.</source>
        <translation>G10 mit L{} beginnt, Daten der Steuerung zu setzen; die Sätze bis G11 werden übersprungen.</translation>
    </message>
    <message>
        <source>What depends on these data is unverified.</source>
        <translation>Was von diesen Daten abhängt, ist ungeprüft.</translation>
    </message>
    <message>
        <source>The offset register {} is not known.</source>
        <translation>Der Korrekturspeicher {} ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The tool with its number fills it, or G10; add the tool, or correct the number.</source>
        <translation>Das Werkzeug mit seiner Nummer füllt ihn, oder G10; das Werkzeug ergänzen oder die Nummer berichtigen.</translation>
    </message>
    <message>
        <source>{} changes the tool length without a Z word; some machines move by the difference, others do not.</source>
        <translation>{} ändert die Werkzeuglänge ohne Z-Wort; manche Maschinen fahren um die Differenz, andere nicht.</translation>
    </message>
    <message>
        <source>Position Z in the same block; here Z does not move.</source>
        <translation>Z im selben Satz positionieren; hier bewegt sich Z nicht.</translation>
    </message>
    <message>
        <source>{} suspends cutter compensation on its way.</source>
        <translation>{} setzt die Fräserradiuskorrektur während der Bewegung aus.</translation>
    </message>
    <message>
        <source>Cutter compensation cannot begin on an arc (alarm 034).</source>
        <translation>Die Fräserradiuskorrektur kann nicht auf einem Kreisbogen beginnen (Alarm 034).</translation>
    </message>
    <message>
        <source>Lead in with G0 or G1; the arc is skipped.</source>
        <translation>Mit G0 oder G1 anfahren; der Kreisbogen wird übersprungen.</translation>
    </message>
    <message>
        <source>The corner before this motion is not compensated: the tool stops square to the end of the block before it, and continues from there.</source>
        <translation>Die Ecke vor dieser Bewegung wird nicht korrigiert: Das Werkzeug hält rechtwinklig zum Ende des Satzes davor und fährt von dort weiter.</translation>
    </message>
    <message>
        <source>Keep stops, repeated codes and blocks without a motion away from corners.</source>
        <translation>Halte, wiederholte Befehle und Sätze ohne Bewegung nicht an Ecken programmieren.</translation>
    </message>
    <message>
        <source>The tool changes side between paths that do not meet.</source>
        <translation>Das Werkzeug wechselt die Seite zwischen Bahnen, die sich nicht treffen.</translation>
    </message>
    <message>
        <source>Write G40 before the other side.</source>
        <translation>Vor dem Wechsel der Seite G40 schreiben.</translation>
    </message>
    <message>
        <source>The tool with a radius of {} mm goes backward in the motion of line {}; the control leaves out points of the corner before it, or stops (alarm 041).</source>
        <translation>Das Werkzeug mit einem Radius von {} mm fährt in der Bewegung von Zeile {} rückwärts; die Steuerung lässt Punkte der Ecke davor weg oder hält an (Alarm 041).</translation>
    </message>
    <message>
        <source>The compensated arc begins {} mm off its circle.</source>
        <translation>Der korrigierte Kreisbogen beginnt {} mm neben seinem Kreis.</translation>
    </message>
    <message>
        <source>Change side, radius or code of compensation before a straight motion.</source>
        <translation>Seite, Radius oder Befehl der Korrektur vor einer geraden Bewegung wechseln.</translation>
    </message>
    <message>
        <source>Interpretation was stopped before this line; the last one was {}.</source>
        <translation>Die Interpretation wurde vor dieser Zeile angehalten; die letzte war {}.</translation>
    </message>
    <message>
        <source>The program is still being read; the lines from here on are missing.</source>
        <translation>Das Programm wird noch gelesen; die Zeilen ab hier fehlen noch.</translation>
    </message>
    <message>
        <source>The control reports error:20 (unsupported command) and skips the block; remove it.</source>
        <translation>Die Steuerung meldet error:20 (Befehl nicht unterstützt) und überspringt den Satz; den Befehl entfernen.</translation>
    </message>
    <message>
        <source>The control reports error:1 (letter expected) and skips the block; remove the character.</source>
        <translation>Die Steuerung meldet error:1 (Buchstabe erwartet) und überspringt den Satz; das Zeichen entfernen.</translation>
    </message>
    <message>
        <source>The control reports error:2 (bad number) and skips the block; write the number.</source>
        <translation>Die Steuerung meldet error:2 (ungültige Zahl) und überspringt den Satz; die Zahl schreiben.</translation>
    </message>
    <message>
        <source>The control reports error:2 (bad number) and skips the block; write one sign.</source>
        <translation>Die Steuerung meldet error:2 (ungültige Zahl) und überspringt den Satz; nur ein Vorzeichen schreiben.</translation>
    </message>
    <message>
        <source>The control reports error:2 (bad number) and skips the block; keep one point.</source>
        <translation>Die Steuerung meldet error:2 (ungültige Zahl) und überspringt den Satz; nur einen Punkt stehen lassen.</translation>
    </message>
    <message>
        <source>The control reports error:1 or error:2 and skips the block; let the CAM system write plain numbers.</source>
        <translation>Die Steuerung meldet error:1 oder error:2 und überspringt den Satz; das CAM-System einfache Zahlen ausgeben lassen.</translation>
    </message>
    <message>
        <source>The control reports error:4 (negative value) and skips the block; correct the number.</source>
        <translation>Die Steuerung meldet error:4 (negativer Wert) und überspringt den Satz; die Zahl berichtigen.</translation>
    </message>
    <message>
        <source>The control reports error:21 (two codes of one group) and skips the block; make two blocks.</source>
        <translation>Die Steuerung meldet error:21 (zwei Befehle einer Gruppe) und überspringt den Satz; auf zwei Sätze aufteilen.</translation>
    </message>
    <message>
        <source>The control reports error:22 (no feed rate) and skips the block, its motion code too; give F.</source>
        <translation>Die Steuerung meldet error:22 (kein Vorschub) und überspringt den Satz samt Bewegungsbefehl; F angeben.</translation>
    </message>
    <message>
        <source>The control reports error:20 or error:23 and skips the block; remove the code.</source>
        <translation>Die Steuerung meldet error:20 oder error:23 und überspringt den Satz; den Befehl entfernen.</translation>
    </message>
    <message>
        <source>The control reports error:24 (two codes use the axis words) and skips the block; make two blocks.</source>
        <translation>Die Steuerung meldet error:24 (zwei Befehle verwenden die Achswörter) und überspringt den Satz; auf zwei Sätze aufteilen.</translation>
    </message>
    <message>
        <source>The control reports error:25 (repeated word) and skips the block; make two blocks.</source>
        <translation>Die Steuerung meldet error:25 (doppeltes Wort) und überspringt den Satz; auf zwei Sätze aufteilen.</translation>
    </message>
    <message>
        <source>The control reports error:26 (no axis words) or error:28 (a word is missing) and skips the block; add the word.</source>
        <translation>Die Steuerung meldet error:26 (keine Achswörter) oder error:28 (ein Wort fehlt) und überspringt den Satz; das Wort ergänzen.</translation>
    </message>
    <message>
        <source>The control reports error:29 to P of G10, error:38 to T, and skips the block; correct the number.</source>
        <translation>Die Steuerung meldet error:29 bei P von G10, error:38 bei T und überspringt den Satz; die Zahl berichtigen.</translation>
    </message>
    <message>
        <source>The control reports error:30 (G53 needs G0 or G1) and skips the block; write G53 G0 or G53 G1.</source>
        <translation>Die Steuerung meldet error:30 (G53 braucht G0 oder G1) und überspringt den Satz; G53 G0 oder G53 G1 schreiben.</translation>
    </message>
    <message>
        <source>The control reports error:31 (axis words without a motion) and skips the block; write G0 or G1.</source>
        <translation>Die Steuerung meldet error:31 (Achswörter ohne Bewegung) und überspringt den Satz; G0 oder G1 schreiben.</translation>
    </message>
    <message>
        <source>The control reports error:26 or error:32 and skips the block; write the end point, also of a full circle.</source>
        <translation>Die Steuerung meldet error:26 oder error:32 und überspringt den Satz; den Endpunkt schreiben, auch bei einem Vollkreis.</translation>
    </message>
    <message>
        <source>The control reports error:33 (invalid target): the radii may differ by 0.005 mm, and by 0.1 % up to 0.5 mm; check the centre.</source>
        <translation>Die Steuerung meldet error:33 (ungültiges Ziel): Die Radien dürfen um 0.005 mm abweichen, und um 0.1 % bis zu 0.5 mm; den Mittelpunkt prüfen.</translation>
    </message>
    <message>
        <source>The control reports error:33 (invalid target) and skips the block; give a full circle its centre.</source>
        <translation>Die Steuerung meldet error:33 (ungültiges Ziel) und überspringt den Satz; für den Vollkreis den Mittelpunkt angeben.</translation>
    </message>
    <message>
        <source>The control reports error:33 (invalid target) and skips the block; check the axis words.</source>
        <translation>Die Steuerung meldet error:33 (ungültiges Ziel) und überspringt den Satz; die Achswörter prüfen.</translation>
    </message>
    <message>
        <source>The control reports error:34 (arc radius) and skips the block; check R and the end point.</source>
        <translation>Die Steuerung meldet error:34 (Radius des Kreisbogens) und überspringt den Satz; R und den Endpunkt prüfen.</translation>
    </message>
    <message>
        <source>The control reports error:35 (no centre in the plane) and skips the block; give I, J or K of the plane, or R.</source>
        <translation>Die Steuerung meldet error:35 (kein Mittelpunkt in der Ebene) und überspringt den Satz; I, J oder K der Ebene oder R angeben.</translation>
    </message>
    <message>
        <source>The control reports error:36 (unused words) and skips the block; keep the centre or the radius.</source>
        <translation>Die Steuerung meldet error:36 (unbenutzte Wörter) und überspringt den Satz; nur den Mittelpunkt oder nur den Radius behalten.</translation>
    </message>
    <message>
        <source>The control reports error:36 (unused words) and skips the block; remove the word.</source>
        <translation>Die Steuerung meldet error:36 (unbenutzte Wörter) und überspringt den Satz; das Wort entfernen.</translation>
    </message>
    <message>
        <source>The control reports error:37 and skips the block; write G43.1 Z… alone.</source>
        <translation>Die Steuerung meldet error:37 und überspringt den Satz; G43.1 Z… allein schreiben.</translation>
    </message>
    <message>
        <source>seek the reference switches</source>
        <translation>Referenzschalter anfahren</translation>
    </message>
    <message>
        <source>work offset 6, or by number</source>
        <translation>Nullpunktverschiebung 6 oder über ihre Nummer</translation>
    </message>
    <message>
        <source>restart the program</source>
        <translation>Programm neu starten</translation>
    </message>
    <message>
        <source>The program has N{} more than once; the jump goes to the one in line {}.</source>
        <translation>Das Programm hat N{} mehr als einmal; der Sprung führt zu dem in Zeile {}.</translation>
    </message>
    <message>
        <source>Controls search in different directions; give each target a number of its own.</source>
        <translation>Steuerungen suchen in verschiedene Richtungen; jedem Sprungziel eine eigene Nummer geben.</translation>
    </message>
    <message>
        <source>{} belongs to no modal group of milling that the manuals name.</source>
        <translation>{} gehört zu keiner modalen Gruppe des Fräsens, die die Handbücher nennen.</translation>
    </message>
    <message>
        <source>Only the control knows its value; what follows from it is unverified.</source>
        <translation>Nur die Steuerung kennt den Wert; was daraus folgt, ist ungeprüft.</translation>
    </message>
    <message>
        <source>{} is not supported by this control.</source>
        <translation>{} wird von dieser Steuerung nicht unterstützt.</translation>
    </message>
    <message>
        <source>The control skips the block, and so does the simulation; remove the code.</source>
        <translation>Die Steuerung überspringt den Satz, die Simulation ebenso; den Befehl entfernen.</translation>
    </message>
    <message>
        <source>This control has no word {}.</source>
        <translation>Diese Steuerung hat kein Wort {}.</translation>
    </message>
    <message>
        <source>The control skips the block, and so does the simulation; remove the word.</source>
        <translation>Die Steuerung überspringt den Satz, die Simulation ebenso; das Wort entfernen.</translation>
    </message>
    <message>
        <source>This control has neither parameters nor expressions.</source>
        <translation>Diese Steuerung hat weder Parameter noch Ausdrücke.</translation>
    </message>
    <message>
        <source>Let the CAM system write plain numbers.</source>
        <translation>Das CAM-System einfache Zahlen ausgeben lassen.</translation>
    </message>
    <message>
        <source>The line has {} characters without blanks and comments; the control reads no more than {}.</source>
        <translation>Die Zeile hat {} Zeichen ohne Leerzeichen und Kommentare; die Steuerung liest nicht mehr als {}.</translation>
    </message>
    <message>
        <source>The control reports error:11 and skips the line; split it.</source>
        <translation>Die Steuerung meldet error:11 und überspringt die Zeile; die Zeile aufteilen.</translation>
    </message>
    <message>
        <source>The block number is larger than {}.</source>
        <translation>Die Satznummer ist größer als {}.</translation>
    </message>
    <message>
        <source>The control reports error:27 and skips the block; renumber the blocks.</source>
        <translation>Die Steuerung meldet error:27 und überspringt den Satz; die Sätze neu nummerieren.</translation>
    </message>
    <message>
        <source>{} is a command to the control itself; it is not simulated.</source>
        <translation>{} ist ein Befehl an die Steuerung selbst; er wird nicht simuliert.</translation>
    </message>
    <message>
        <source>It may move axes, change settings or clear offsets; send it apart from the program.</source>
        <translation>Er kann Achsen bewegen, Einstellungen ändern oder Verschiebungen löschen; getrennt vom Programm senden.</translation>
    </message>
    <message>
        <source>The character {} is a real-time command that acts anywhere, even in comments.</source>
        <translation>Das Zeichen {} ist ein Echtzeitbefehl, der überall wirkt, auch in Kommentaren.</translation>
    </message>
    <message>
        <source>It may stop the machine or change an override; remove it.</source>
        <translation>Es kann die Maschine anhalten oder einen Override ändern; das Zeichen entfernen.</translation>
    </message>
    <message>
        <source>The character {} resets the control or stops it in the middle of the program.</source>
        <translation>Das Zeichen {} setzt die Steuerung zurück oder hält sie mitten im Programm an.</translation>
    </message>
    <message>
        <source>Remove it.</source>
        <translation>Entfernen.</translation>
    </message>
    <message>
        <source>This control has no block delete: it runs what follows &quot;/&quot;.</source>
        <translation>Diese Steuerung kann keine Sätze ausblenden: Sie führt aus, was nach „/“ steht.</translation>
    </message>
    <message>
        <source>Remove the blocks that must not run.</source>
        <translation>Die Sätze entfernen, die nicht ausgeführt werden dürfen.</translation>
    </message>
    <message>
        <source>This control does not know &quot;%&quot;.</source>
        <translation>Diese Steuerung kennt „%“ nicht.</translation>
    </message>
    <message>
        <source>The control reports error:1 unless the sender filters the line; remove it.</source>
        <translation>Die Steuerung meldet error:1, wenn das Sendeprogramm die Zeile nicht ausfiltert; die Zeile entfernen.</translation>
    </message>
    <message>
        <source>T{} is read, but changes nothing: this control has no tool change.</source>
        <translation>T{} wird gelesen, ändert aber nichts: Diese Steuerung hat keinen Werkzeugwechsel.</translation>
    </message>
    <message>
        <source>Make one program per tool, or change the tool by hand after M0.</source>
        <translation>Für jedes Werkzeug ein eigenes Programm erstellen oder das Werkzeug nach M0 von Hand wechseln.</translation>
    </message>
    <message>
        <source>This control does not stop at M1.</source>
        <translation>Diese Steuerung hält bei M1 nicht an.</translation>
    </message>
    <message>
        <source>Write M0 where it must stop.</source>
        <translation>M0 schreiben, wo die Maschine anhalten muss.</translation>
    </message>
    <message>
        <source>M7 is known only where grbl was built with mist coolant.</source>
        <translation>M7 ist nur bekannt, wo grbl mit Sprühkühlung kompiliert wurde.</translation>
    </message>
    <message>
        <source>Otherwise grbl reports error:20 and skips the block; give M7 a block of its own.</source>
        <translation>Sonst meldet grbl error:20 und überspringt den Satz; M7 in einen eigenen Satz schreiben.</translation>
    </message>
    <message>
        <source>The centre word {} is outside the plane of the arc; the control ignores it.</source>
        <translation>Das Mittelpunktwort {} liegt außerhalb der Ebene des Kreisbogens; die Steuerung ignoriert es.</translation>
    </message>
    <message>
        <source>The arc has no end point in its plane.</source>
        <translation>Der Kreisbogen hat keinen Endpunkt in seiner Ebene.</translation>
    </message>
    <message>
        <source>Write the end point, also of a full circle.</source>
        <translation>Den Endpunkt schreiben, auch bei einem Vollkreis.</translation>
    </message>
    <message>
        <source>G43.1 takes the word Z and no other axis on this control.</source>
        <translation>G43.1 erlaubt auf dieser Steuerung das Wort Z und keine andere Achse.</translation>
    </message>
    <message>
        <source>Write G43.1 Z… in a block of its own.</source>
        <translation>G43.1 Z… in einen eigenen Satz schreiben.</translation>
    </message>
    <message>
        <source>This control knows O with a number alone, as the beginning of a subprogram.</source>
        <translation>Diese Steuerung kennt O nur mit einer Zahl, als Anfang eines Unterprogramms.</translation>
    </message>
    <message>
        <source>Call it with M98 and end it with M99.</source>
        <translation>Mit M98 aufrufen und mit M99 beenden.</translation>
    </message>
    <message>
        <source>A setting of the control decides whether the dwell of {} is {} s or {} s; it is taken as the first.</source>
        <translation>Eine Einstellung der Steuerung entscheidet, ob die Verweilzeit von {} {} s oder {} s ist; angenommen wird die erste.</translation>
    </message>
    <message>
        <source>Check on the control whether P counts seconds or milliseconds.</source>
        <translation>An der Steuerung prüfen, ob P Sekunden oder Millisekunden zählt.</translation>
    </message>
    <message>
        <source>The arc fits with its centre from the start point and also from the origin; a setting of the control decides. The start point is assumed.</source>
        <translation>Der Kreisbogen passt mit einem Mittelpunkt ab dem Startpunkt und auch ab dem Nullpunkt; eine Einstellung der Steuerung entscheidet. Angenommen wird der Startpunkt.</translation>
    </message>
    <message>
        <source>Write G91.1 or G90.1 at the beginning of the program.</source>
        <translation>G91.1 oder G90.1 an den Anfang des Programms schreiben.</translation>
    </message>
    <message>
        <source>Mach3 uses the tool position as the pole of G16, Mach4 the origin; Mach3 is assumed.</source>
        <translation>Mach3 verwendet die Werkzeugposition als Pol von G16, Mach4 den Nullpunkt; angenommen wird Mach3.</translation>
    </message>
    <message>
        <source>Begin the polar coordinates where both are the same: at X0 Y0.</source>
        <translation>Die Polarkoordinaten dort beginnen, wo beide gleich sind: bei X0 Y0.</translation>
    </message>
    <message>
        <source>Polar coordinates are for G0 and G1 in the XY plane; their effect on {} is not documented.</source>
        <translation>Polarkoordinaten gelten für G0 und G1 in der XY-Ebene; ihre Wirkung auf {} ist nicht dokumentiert.</translation>
    </message>
    <message>
        <source>Write G15 before it.</source>
        <translation>G15 davor schreiben.</translation>
    </message>
    <message>
        <source>Whether G51 scales the word {} is not documented; it is assumed to.</source>
        <translation>Ob G51 das Wort {} skaliert, ist nicht dokumentiert; angenommen wird, dass es skaliert wird.</translation>
    </message>
    <message>
        <source>Write G50 before it, or give the centre of an arc by I and J.</source>
        <translation>G50 davor schreiben oder den Mittelpunkt des Kreisbogens mit I und J angeben.</translation>
    </message>
    <message>
        <source>{} works in the XY plane only.</source>
        <translation>{} wirkt nur in der XY-Ebene.</translation>
    </message>
    <message>
        <source>Write G17 before it; the code has no effect.</source>
        <translation>G17 davor schreiben; der Befehl hat keine Wirkung.</translation>
    </message>
    <message>
        <source>{} without H, or with H0, sets the tool length offset to 0.</source>
        <translation>{} ohne H oder mit H0 setzt die Werkzeuglängenkorrektur auf 0.</translation>
    </message>
    <message>
        <source>Write the tool number after H.</source>
        <translation>Die Werkzeugnummer nach H schreiben.</translation>
    </message>
    <message>
        <source>M47 restarts the program, endlessly.</source>
        <translation>M47 startet das Programm endlos neu.</translation>
    </message>
    <message>
        <source>{} seeks the reference switches; the axis positions afterwards are unknown.</source>
        <translation>{} fährt die Referenzschalter an; die Achspositionen danach sind unbekannt.</translation>
    </message>
    <message>
        <source>Position the axes before the next cut.</source>
        <translation>Die Achsen vor dem nächsten Schnitt positionieren.</translation>
    </message>
    <message>
        <source>This block is unreachable: line {} always jumps past it.</source>
        <translation>Dieser Satz ist nicht erreichbar: Zeile {} springt immer an ihm vorbei.</translation>
    </message>
    <message>
        <source>Remove it, or give it the block number or label of a jump.</source>
        <translation>Den Satz entfernen oder ihm die Satznummer oder Marke eines Sprungs geben.</translation>
    </message>
    <message>
        <source>T{} is selected, but the tool table does not have it.</source>
        <translation>T{} wird gewählt, steht aber nicht in der Werkzeugtabelle.</translation>
    </message>
    <message>
        <source>Add the tool, or correct the number.</source>
        <translation>Das Werkzeug ergänzen oder die Nummer berichtigen.</translation>
    </message>
    <message>
        <source>chamfer</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>The chamfer or corner radius is not between two straight or circular motions (alarm 051).</source>
        <translation>Fase oder Eckenradius liegt nicht zwischen zwei Geraden oder Kreisbögen (Alarm 051).</translation>
    </message>
    <message>
        <source>Program G1, G2 or G3 in the plane next; the corner stays sharp.</source>
        <translation>Als Nächstes G1, G2 oder G3 in der Ebene programmieren; die Ecke bleibt scharf.</translation>
    </message>
    <message>
        <source>The chamfer or corner radius of {} mm does not fit between the motions (alarm 055).</source>
        <translation>Die Fase oder der Eckenradius von {} mm passt nicht zwischen die Bewegungen (Alarm 055).</translation>
    </message>
    <message>
        <source>Use a smaller one; the corner stays sharp.</source>
        <translation>Ein kleineres Maß verwenden; die Ecke bleibt scharf.</translation>
    </message>
    <message>
        <source>A chamfer or corner radius needs motions in one plane on both sides.</source>
        <translation>Fase oder Eckenradius braucht auf beiden Seiten Bewegungen in einer Ebene.</translation>
    </message>
    <message>
        <source>Move along the third axis in another block; the corner stays sharp.</source>
        <translation>Die dritte Achse in einem anderen Satz bewegen; die Ecke bleibt scharf.</translation>
    </message>
    <message>
        <source>The manuals do not say how a chamfer is measured along an arc; here it is the straight distance from the corner.</source>
        <translation>Die Handbücher sagen nicht, wie eine Fase an einem Kreisbogen gemessen wird; hier ist es der gerade Abstand von der Ecke.</translation>
    </message>
    <message>
        <source>Write the motions out.</source>
        <translation>Die Bewegungen ausschreiben.</translation>
    </message>
    <message>
        <source>#5061 to #5063 hold that end. With a stock and a cutter for its tool it stops at the stock.</source>
        <translation>#5061 bis #5063 enthalten diesen Endpunkt. Mit einem Rohteil und einem Fräser für ihr Werkzeug hält sie am Rohteil.</translation>
    </message>
    <message>
        <source>It is assumed to move to its programmed end; #5061 to #5069 hold that, #5070 is 0. With a stock and a cutter for its tool it stops at the stock.</source>
        <translation>Angenommen wird, dass er bis zum programmierten Endpunkt fährt; #5061 bis #5069 enthalten diesen, #5070 ist 0. Mit einem Rohteil und einem Fräser für sein Werkzeug hält er am Rohteil.</translation>
    </message>
    <message>
        <source>The probe is assumed to stop at X{} Y{} Z{} mm, where it touches the simulated stock.</source>
        <translation>Angenommen wird, dass der Taster bei X{} Y{} Z{} mm hält, wo er das simulierte Rohteil berührt.</translation>
    </message>
    <message>
        <source>On the machine the part decides; results are verified as long as the program does not continue from there or read the result.</source>
        <translation>An der Maschine entscheidet das Werkstück; die Ergebnisse sind geprüft, solange das Programm nicht von dort weiterfährt oder das Ergebnis liest.</translation>
    </message>
    <message>
        <source>The probe is assumed to stop at X{} Y{} Z{} mm, where it leaves the simulated stock.</source>
        <translation>Angenommen wird, dass der Taster bei X{} Y{} Z{} mm hält, wo er das simulierte Rohteil verlässt.</translation>
    </message>
    <message>
        <source>This line uses a probing result, which is assumed from the simulated stock.</source>
        <translation>Diese Zeile verwendet ein Antastergebnis, das nach dem simulierten Rohteil angenommen ist.</translation>
    </message>
    <message>
        <source>Results are shown for that stop; on another part they are unverified.</source>
        <translation>Die Ergebnisse gelten für diesen Halt; für ein anderes Werkstück sind sie ungeprüft.</translation>
    </message>
    <message>
        <source>{} reaches its end without touching the simulated stock; the control stops there.</source>
        <translation>{} erreicht sein Ende, ohne das simulierte Rohteil zu berühren; die Steuerung hält dort an.</translation>
    </message>
    <message>
        <source>Check stock, tool and offsets, or probe farther.</source>
        <translation>Rohteil, Werkzeug und Korrekturen prüfen oder weiter antasten.</translation>
    </message>
    <message>
        <source>{} reaches its end without leaving the simulated stock; the control stops there.</source>
        <translation>{} erreicht sein Ende, ohne das simulierte Rohteil zu verlassen; die Steuerung hält dort an.</translation>
    </message>
    <message>
        <source>Check stock, tool and offsets, or move farther.</source>
        <translation>Rohteil, Werkzeug und Korrekturen prüfen oder weiter fahren.</translation>
    </message>
    <message>
        <source>{} begins where the probe touches the simulated stock; the control stops there.</source>
        <translation>{} beginnt dort, wo der Taster das simulierte Rohteil berührt; die Steuerung hält dort an.</translation>
    </message>
    <message>
        <source>Retract before it; the motion is skipped.</source>
        <translation>Vorher freifahren; die Bewegung wird übersprungen.</translation>
    </message>
    <message>
        <source>{} begins where the probe touches nothing of the simulated stock; the control stops there.</source>
        <translation>{} beginnt dort, wo der Taster nichts vom simulierten Rohteil berührt; die Steuerung hält dort an.</translation>
    </message>
    <message>
        <source>Touch the part before it; the motion is skipped.</source>
        <translation>Vorher das Werkstück berühren; die Bewegung wird übersprungen.</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>The block after the chamfer or corner radius has no G1, G2 or G3 (alarm 052, on newer controls 051).</source>
        <translation>Der Satz nach der Fase oder dem Eckenradius hat weder G1, G2 noch G3 (Alarm 052, bei neueren Steuerungen 051).</translation>
    </message>
    <message>
        <source>Only one dwell, in a block of its own, is allowed between them; the corner stays sharp.</source>
        <translation>Dazwischen ist nur eine Verweilzeit in einem eigenen Satz erlaubt; die Ecke bleibt scharf.</translation>
    </message>
    <message>
        <source>The block has both a chamfer and a corner radius (alarm 053).</source>
        <translation>Der Satz hat eine Fase und einen Eckenradius (Alarm 053).</translation>
    </message>
    <message>
        <source>Keep one of them; the corner stays sharp.</source>
        <translation>Nur eines davon behalten; die Ecke bleibt scharf.</translation>
    </message>
    <message>
        <source>Expected C or R after the comma (alarm 053).</source>
        <translation>C oder R nach dem Komma erwartet (Alarm 053).</translation>
    </message>
    <message>
        <source>Write ,C for a chamfer and ,R for a corner radius.</source>
        <translation>Für eine Fase ,C und für einen Eckenradius ,R schreiben.</translation>
    </message>
    <message>
        <source>The chamfer or corner radius of {} mm is negative.</source>
        <translation>Die Fase oder der Eckenradius von {} mm ist negativ.</translation>
    </message>
    <message>
        <source>Write it without a sign; the corner stays sharp.</source>
        <translation>Ohne Vorzeichen schreiben; die Ecke bleibt scharf.</translation>
    </message>
    <message>
        <source>The manuals do not say whether G51 also scales chamfers and corner radii; here it does not.</source>
        <translation>Die Handbücher sagen nicht, ob G51 auch Fasen und Eckenradien skaliert; hier tut es das nicht.</translation>
    </message>
    <message>
        <source>A setting of the control decides whether G68 with G91 adds its angle to the active one (Fanuc: parameter 5400#0, Haas: setting 73); here the angle is {} degrees.</source>
        <translation>Eine Einstellung der Steuerung entscheidet, ob G68 mit G91 seinen Winkel zum aktiven addiert (Fanuc: Parameter 5400#0, Haas: Einstellung 73); hier beträgt der Winkel {} Grad.</translation>
    </message>
    <message>
        <source>Write G90 before G68, or G69 between them.</source>
        <translation>G90 vor G68 oder G69 dazwischen schreiben.</translation>
    </message>
    <message>
        <source>{} is not allowed while a canned cycle is active (alarm 044).</source>
        <translation>{} ist nicht erlaubt, solange ein Festzyklus aktiv ist (Alarm 044).</translation>
    </message>
    <message>
        <source>End the cycle with G80 before it.</source>
        <translation>Den Zyklus vorher mit G80 beenden.</translation>
    </message>
    <message>
        <source>A chamfer or corner radius is not allowed where cutter compensation starts, ends or changes side (alarm 039).</source>
        <translation>Fase oder Eckenradius ist nicht erlaubt, wo die Fräserradiuskorrektur beginnt, endet oder die Seite wechselt (Alarm 039).</translation>
    </message>
    <message>
        <source>Put it between other motions; the corner stays sharp.</source>
        <translation>Zwischen andere Bewegungen setzen; die Ecke bleibt scharf.</translation>
    </message>
    <message>
        <source>Reading the file was cancelled.</source>
        <translation>Das Lesen der Datei wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is not enough memory to read the file.</source>
        <translation>Der Speicher reicht nicht, um die Datei zu lesen.</translation>
    </message>
    <message>
        <source>Reading the file failed: {}.</source>
        <translation>Das Lesen der Datei ist fehlgeschlagen: {}.</translation>
    </message>
    <message>
        <source>The file was not opened because the open program was edited while the file was being read.</source>
        <translation>Die Datei wurde nicht geöffnet, weil das geöffnete Programm währenddessen bearbeitet wurde.</translation>
    </message>
    <message>
        <source>More than five brackets are nested; the control gives alarm 118.</source>
        <translation>Mehr als fünf Klammern sind verschachtelt; die Steuerung meldet Alarm 118.</translation>
    </message>
    <message>
        <source>The centre of {} is the current position, which is unknown for {}.</source>
        <translation>Der Mittelpunkt von {} ist die aktuelle Position, die für {} unbekannt ist.</translation>
    </message>
    <message>
        <source>Program the centre, or position the tool first.</source>
        <translation>Den Mittelpunkt programmieren oder zuerst das Werkzeug positionieren.</translation>
    </message>
    <message>
        <source>The profile at character {} has no width.</source>
        <translation>Das Profil bei Zeichen {} hat keine Breite.</translation>
    </message>
    <message>
        <source>The profile continues at character {} after {} points; it may have no more.</source>
        <translation>Das Profil geht bei Zeichen {} nach {} Punkten weiter; mehr sind nicht erlaubt.</translation>
    </message>
    <message>
        <source>At character {} the profile turns back towards the axis.</source>
        <translation>Bei Zeichen {} kehrt das Profil zur Achse zurück.</translation>
    </message>
    <message>
        <source>At character {}, “{}” is not a profile point; a point is written as {}, an arc to it as {} or {}.</source>
        <translation>Bei Zeichen {} ist „{}“ kein Profilpunkt; ein Punkt wird wie {} geschrieben, ein Kreisbogen dorthin wie {} oder {}.</translation>
    </message>
    <message>
        <source>At character {} the profile falls; from the axis outwards it may only rise or stay.</source>
        <translation>Bei Zeichen {} fällt das Profil; von der Achse nach außen darf es nur steigen oder gleich bleiben.</translation>
    </message>
    <message>
        <source>At character {} the profile begins with “{}”, not at the tip, {}.</source>
        <translation>Bei Zeichen {} beginnt das Profil mit „{}“ statt an der Spitze, {}.</translation>
    </message>
    <message>
        <source>The arc at character {} has the radius {} mm, too small for ends {} mm apart.</source>
        <translation>Der Kreisbogen bei Zeichen {} hat den Radius {} mm, zu klein für Enden im Abstand von {} mm.</translation>
    </message>
    <message>
        <source>The arc at character {} has ends that are {} mm and {} mm away from its centre.</source>
        <translation>Die Enden des Kreisbogens bei Zeichen {} sind {} mm und {} mm von seinem Mittelpunkt entfernt.</translation>
    </message>
    <message>
        <source>The arc at character {} falls or turns back towards the axis; it may be a quarter of a circle at most, from level to upright.</source>
        <translation>Der Kreisbogen bei Zeichen {} fällt oder kehrt zur Achse zurück; er darf höchstens ein Viertelkreis sein, von waagrecht bis senkrecht.</translation>
    </message>
    <message>
        <source>Before character {} the profile rises on the axis itself; its tip has no width.</source>
        <translation>Vor Zeichen {} steigt das Profil auf der Achse selbst; seine Spitze hat keine Breite.</translation>
    </message>
    <message>
        <source>The arcs up to character {} are so large that they take more than {} lines.</source>
        <translation>Die Kreisbögen bis Zeichen {} sind so groß, dass sie mehr als {} Geraden brauchen.</translation>
    </message>
    <message>
        <source>The pilot, pilot={}, is not smaller than the diameter, {} mm.</source>
        <translation>Der Zapfen, pilot={}, ist nicht kleiner als der Durchmesser, {} mm.</translation>
    </message>
    <message>
        <source>The pilot, pl={}, is shorter than its point, {} mm.</source>
        <translation>Der Zapfen, pl={}, ist kürzer als seine Spitze, {} mm.</translation>
    </message>
    <message>
        <source>The lead, lead={}, ends in a point; {} mm is the longest.</source>
        <translation>Der Anschnitt, lead={}, läuft in einer Spitze zusammen; die größte Länge ist {} mm.</translation>
    </message>
    <message>
        <source>The height h={} is not more than that of the rounded tip, {} mm.</source>
        <translation>Die Höhe h={} ist nicht größer als die der gerundeten Spitze, {} mm.</translation>
    </message>
    <message>
        <source>The neck, neck={}, must be thinner than {} mm, the head at its top.</source>
        <translation>Der Hals, neck={}, muss dünner sein als {} mm, der Kopf an seiner Oberseite.</translation>
    </message>
    <message>
        <source>With h={} the flanks meet below the top; {} mm is the limit.</source>
        <translation>Mit h={} treffen sich die Flanken unter der Oberseite; die Grenze ist {} mm.</translation>
    </message>
    <message>
        <source>A cutter of the shape {} needs the key {} ({}), e.g. {}.</source>
        <translation>Ein Fräser der Form {} braucht den Schlüssel {} ({}), z. B. {}.</translation>
    </message>
    <message>
        <source>The corner radius r={} does not fit; {} mm is the largest.</source>
        <translation>Der Eckenradius r={} passt nicht; der größte ist {} mm.</translation>
    </message>
    <message>
        <source>Angle of each side</source>
        <translation>Winkel je Seite</translation>
    </message>
    <message>
        <source>Height of the taper</source>
        <translation>Höhe des Kegels</translation>
    </message>
    <message>
        <source>Diameter at the tip</source>
        <translation>Durchmesser an der Spitze</translation>
    </message>
    <message>
        <source>Diameter of the ball</source>
        <translation>Durchmesser der Kugel</translation>
    </message>
    <message>
        <source>Diameter of the pilot</source>
        <translation>Durchmesser des Zapfens</translation>
    </message>
    <message>
        <source>Length of the pilot with its point</source>
        <translation>Länge des Zapfens mit Spitze</translation>
    </message>
    <message>
        <source>Point angle of the pilot</source>
        <translation>Spitzenwinkel des Zapfens</translation>
    </message>
    <message>
        <source>Length of the lead</source>
        <translation>Länge des Anschnitts</translation>
    </message>
    <message>
        <source>Approach angle of the edge</source>
        <translation>Einstellwinkel der Schneide</translation>
    </message>
    <message>
        <source>Height of the edge</source>
        <translation>Höhe der Schneide</translation>
    </message>
    <message>
        <source>Profile, RADIUS/HEIGHT:… from the tip outwards</source>
        <translation>Profil, RADIUS/HÖHE:… von der Spitze nach außen</translation>
    </message>
    <message>
        <source>Diameter of the neck</source>
        <translation>Durchmesser des Halses</translation>
    </message>
    <message>
        <source>Width of the head</source>
        <translation>Breite des Kopfes</translation>
    </message>
    <message>
        <source>Angle between face and flank</source>
        <translation>Winkel zwischen Stirn und Flanke</translation>
    </message>
    <message>
        <source>Height of the head</source>
        <translation>Höhe des Kopfes</translation>
    </message>
    <message>
        <source>Diameter of the neck (0: as the head&apos;s top)</source>
        <translation>Durchmesser des Halses (0: wie die Oberseite des Kopfes)</translation>
    </message>
    <message>
        <source>Tapered end mill</source>
        <translation>Konischer Schaftfräser</translation>
    </message>
    <message>
        <source>Tapered ball-end mill</source>
        <translation>Konischer Kugelfräser</translation>
    </message>
    <message>
        <source>Chamfer mill</source>
        <translation>Fasenfräser</translation>
    </message>
    <message>
        <source>Face mill</source>
        <translation>Planfräser</translation>
    </message>
    <message>
        <source>Spot drill</source>
        <translation>NC-Anbohrer</translation>
    </message>
    <message>
        <source>Centre drill</source>
        <translation>Zentrierbohrer</translation>
    </message>
    <message>
        <source>Reamer</source>
        <translation>Reibahle</translation>
    </message>
    <message>
        <source>Tap</source>
        <translation>Gewindebohrer</translation>
    </message>
    <message>
        <source>Thread mill</source>
        <translation>Gewindefräser</translation>
    </message>
    <message>
        <source>Lollipop cutter</source>
        <translation>Kugelfräser mit Hals (Lollipop)</translation>
    </message>
    <message>
        <source>T-slot or keyseat cutter</source>
        <translation>T-Nuten- oder Schlitzfräser</translation>
    </message>
    <message>
        <source>Dovetail cutter</source>
        <translation>Schwalbenschwanzfräser</translation>
    </message>
    <message>
        <source>Form cutter</source>
        <translation>Formfräser</translation>
    </message>
    <message>
        <source>The neck of the cutter passes through {} mm of stock above its head.</source>
        <translation>Der Hals des Fräsers geht über dem Kopf durch {} mm Rohteil.</translation>
    </message>
    <message>
        <source>Cut a slot for the neck first, or choose a tool with a thinner neck.</source>
        <translation>Zuerst eine Nut für den Hals fräsen oder ein Werkzeug mit dünnerem Hals wählen.</translation>
    </message>
    <message>
        <source>Above the head of the cutter {} mm³ of stock remain, which the z-map shows as removed; the layer is highest at X{} Y{} Z{}.</source>
        <translation>Über dem Kopf des Fräsers bleiben {} mm³ Rohteil stehen, die die Z-Map als abgetragen zeigt; am höchsten ist die Schicht bei X{} Y{} Z{}.</translation>
    </message>
    <message>
        <source>Check by other means what is cut there from here on.</source>
        <translation>Auf andere Weise prüfen, was dort von hier an gefräst wird.</translation>
    </message>
    <message>
        <source>Proveout stock</source>
        <translation>Proveout-Rohteil</translation>
    </message>
    <message>
        <source>the stock left by a setup</source>
        <translation>das Rohteil, das eine Aufspannung übrig lässt</translation>
    </message>
    <message>
        <source>This line is not a point: X, Y and, for an arc, its bulge.</source>
        <translation>Diese Zeile ist kein Punkt: X, Y und, bei einem Kreisbogen, seine Wölbung.</translation>
    </message>
    <message>
        <source>The loop that ends here has only one point.</source>
        <translation>Der Umriss, der hier endet, hat nur einen Punkt.</translation>
    </message>
    <message>
        <source>The outline has no points.</source>
        <translation>Der Umriss hat keine Punkte.</translation>
    </message>
    <message>
        <source>“{}” is not a key of this stock shape; there are {}.</source>
        <translation>„{}“ ist kein Schlüssel dieser Rohteilform; gültig sind: {}.</translation>
    </message>
    <message>
        <source>{}={} is not a length above {} and at most {} mm.</source>
        <translation>{}={} ist keine Länge über {} und höchstens {} mm.</translation>
    </message>
    <message>
        <source>{}={} is not one of {}.</source>
        <translation>{}={} ist keiner dieser Werte: {}.</translation>
    </message>
    <message>
        <source>The key {} must name a file.</source>
        <translation>Der Schlüssel {} muss eine Datei nennen.</translation>
    </message>
    <message>
        <source>A stock of the shape {} needs the key {}, as in {}.</source>
        <translation>Ein Rohteil der Form {} braucht den Schlüssel {}, wie in {}.</translation>
    </message>
    <message>
        <source>“{}” is not a stock shape; there are {}.</source>
        <translation>„{}“ ist keine Rohteilform; gültig sind: {}.</translation>
    </message>
    <message>
        <source>The saved stock is cut off or damaged: {} in it cannot be read whole.</source>
        <translation>Das gespeicherte Rohteil ist abgeschnitten oder beschädigt: {} darin lässt sich nicht ganz lesen.</translation>
    </message>
    <message>
        <source>This is not a stock that Proveout has saved.</source>
        <translation>Das ist kein Rohteil, das Proveout gespeichert hat.</translation>
    </message>
    <message>
        <source>The stock was saved by a newer Proveout (format {}); this one reads up to format {}.</source>
        <translation>Das Rohteil stammt von einem neueren Proveout (Format {}); dieses liest bis Format {}.</translation>
    </message>
    <message>
        <source>The saved stock specifies {} × {} points, but its size and spacing give {} × {}.</source>
        <translation>Das gespeicherte Rohteil gibt {} × {} Punkte an, aber Größe und Rasterweite ergeben {} × {}.</translation>
    </message>
    <message>
        <source>The heights of the saved stock are not {} × {} numbers of float32.</source>
        <translation>Die Höhen des gespeicherten Rohteils sind nicht {} × {} Zahlen in float32.</translation>
    </message>
    <message>
        <source>Row {}, column {} of the saved stock is not a height within it.</source>
        <translation>Zeile {}, Spalte {} des gespeicherten Rohteils ist keine Höhe innerhalb des Rohteils.</translation>
    </message>
    <message>
        <source>Height Z</source>
        <translation>Höhe Z</translation>
    </message>
    <message>
        <source>Size of the stock along Z, from its top downwards.</source>
        <translation>Größe des Rohteils längs Z, von der Oberseite nach unten.</translation>
    </message>
    <message>
        <source>Width X</source>
        <translation>Breite X</translation>
    </message>
    <message>
        <source>Size of the stock along X.</source>
        <translation>Größe des Rohteils längs X.</translation>
    </message>
    <message>
        <source>Length Y</source>
        <translation>Länge Y</translation>
    </message>
    <message>
        <source>Size of the stock along Y.</source>
        <translation>Größe des Rohteils längs Y.</translation>
    </message>
    <message>
        <source>Diameter of the upright cylinder.</source>
        <translation>Durchmesser des aufrechten Zylinders.</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>A text file with one point X Y per line, and a third number for an arc to the next point: the tangent of a quarter of its angle. An empty line begins another loop.</source>
        <translation>Eine Textdatei mit einem Punkt X Y je Zeile und einer dritten Zahl für einen Kreisbogen zum nächsten Punkt: dem Tangens eines Viertels seines Winkels. Eine leere Zeile beginnt einen weiteren Umriss.</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>A closed mesh, in mm; the stock is everything below its upper surface.</source>
        <translation>Ein geschlossenes Netz, in mm; das Rohteil ist alles unter seiner oberen Fläche.</translation>
    </message>
    <message>
        <source>Not turned</source>
        <translation>Nicht gedreht</translation>
    </message>
    <message>
        <source>90° to the left</source>
        <translation>90° nach links</translation>
    </message>
    <message>
        <source>180°</source>
        <translation>180°</translation>
    </message>
    <message>
        <source>90° to the right</source>
        <translation>90° nach rechts</translation>
    </message>
    <message>
        <source>Not flipped</source>
        <translation>Nicht gewendet</translation>
    </message>
    <message>
        <source>About X</source>
        <translation>Um X</translation>
    </message>
    <message>
        <source>About Y</source>
        <translation>Um Y</translation>
    </message>
    <message>
        <source>Saved stock</source>
        <translation>Gespeichertes Rohteil</translation>
    </message>
    <message>
        <source>The stock left by an earlier setup, as saved by File, Save Stock.</source>
        <translation>Das Rohteil, das eine frühere Aufspannung übrig ließ, gespeichert mit Datei, Rohteil speichern.</translation>
    </message>
    <message>
        <source>Flipped</source>
        <translation>Gewendet</translation>
    </message>
    <message>
        <source>By half a turn, so that the underside is on top; before it is turned.</source>
        <translation>Um eine halbe Drehung, sodass die Unterseite oben liegt; bevor es gedreht wird.</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>About the upright axis, seen from above.</source>
        <translation>Um die senkrechte Achse, von oben gesehen.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>A block with its sides along the axes.</source>
        <translation>Ein Block mit Seiten längs der Achsen.</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>A round bar that stands upright.</source>
        <translation>Ein Rundstab, der aufrecht steht.</translation>
    </message>
    <message>
        <source>Extruded outline</source>
        <translation>Umriss mit Höhe</translation>
    </message>
    <message>
        <source>A plate within a closed outline of lines and arcs, with holes.</source>
        <translation>Eine Platte in einem geschlossenen Umriss aus Linien und Kreisbögen, mit Löchern.</translation>
    </message>
    <message>
        <source>Mesh (STL)</source>
        <translation>Netz (STL)</translation>
    </message>
    <message>
        <source>A casting or a forging, as a closed mesh.</source>
        <translation>Ein Guss- oder Schmiedeteil als geschlossenes Netz.</translation>
    </message>
    <message>
        <source>The stock left by an earlier setup, also flipped or turned.</source>
        <translation>Das Rohteil, das eine frühere Aufspannung übrig ließ, auch gewendet oder gedreht.</translation>
    </message>
    <message>
        <source>This is not a ZIP archive, or one that cannot be read.</source>
        <translation>Das ist kein ZIP-Archiv, oder es lässt sich nicht lesen.</translation>
    </message>
    <message>
        <source>The outline has a point beyond {} mm, or an arc that is nearly a full circle.</source>
        <translation>Der Umriss hat einen Punkt jenseits von {} mm oder einen Kreisbogen, der beinahe ein voller Kreis ist.</translation>
    </message>
    <message>
        <source>The outline crosses itself near X{} Y{}.</source>
        <translation>Der Umriss überkreuzt sich selbst bei X{} Y{}.</translation>
    </message>
    <message>
        <source>The outline encloses no area.</source>
        <translation>Der Umriss schließt keine Fläche ein.</translation>
    </message>
    <message>
        <source>The mesh of the stock is not closed: at {} of {} grid points the material is unknown.</source>
        <translation>Das Netz des Rohteils ist nicht geschlossen: An {} von {} Rasterpunkten ist das Material unbekannt.</translation>
    </message>
    <message>
        <source>Export the stock as a closed solid.</source>
        <translation>Das Rohteil als geschlossenen Körper exportieren.</translation>
    </message>
    <message>
        <source>The mesh of the stock reaches beyond {} mm.</source>
        <translation>Das Netz des Rohteils reicht über {} mm hinaus.</translation>
    </message>
    <message>
        <source>The mesh of the stock encloses no volume.</source>
        <translation>Das Netz des Rohteils schließt kein Volumen ein.</translation>
    </message>
    <message>
        <source>The facets of the stock mesh are in {} layers on average; at most {} can be read.</source>
        <translation>Die Facetten des Rohteilnetzes liegen im Mittel in {} Lagen; höchstens {} lassen sich lesen.</translation>
    </message>
    <message>
        <source>The saved stock has a spacing of {} × {} mm and is resampled to {} × {} mm: never lower at its points, between them up to one spacing wider.</source>
        <translation>Das gespeicherte Rohteil hat eine Rasterweite von {} × {} mm und wird auf {} × {} mm umgerechnet: an seinen Punkten nie niedriger, dazwischen bis zu eine Rasterweite breiter.</translation>
    </message>
    <message>
        <source>Use the spacing of the saved stock, or a whole fraction of it, to avoid resampling.</source>
        <translation>Die Rasterweite des gespeicherten Rohteils oder einen ganzzahligen Teil davon verwenden, um das Umrechnen zu vermeiden.</translation>
    </message>
    <message>
        <source>No stock is left in the saved stock.</source>
        <translation>Vom gespeicherten Rohteil ist nichts übrig.</translation>
    </message>
    <message>
        <source>Below the surface of the stock there are {} mm³ of air, which the z-map shows as material; the tallest gap, {} mm, starts at X{} Y{} Z{}.</source>
        <translation>Unter der Fläche des Rohteils sind {} mm³ Luft, die die Z-Map als Material zeigt; die höchste Lücke, {} mm, beginnt bei X{} Y{} Z{}.</translation>
    </message>
    <message>
        <source>Check the program over such gaps by other means.</source>
        <translation>Das Programm über solchen Lücken auf andere Weise prüfen.</translation>
    </message>
    <message>
        <source>There is not enough memory for the stock.</source>
        <translation>Der Speicher reicht nicht für das Rohteil.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Stop before a line of the program.</source>
        <translation>Vor einer Zeile des Programms halten.</translation>
    </message>
    <message>
        <source>Stopped before line {}.</source>
        <translation>Vor Zeile {} angehalten.</translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation>Werkzeugwechsel</translation>
    </message>
    <message>
        <source>Stop at each tool change.</source>
        <translation>Bei jedem Werkzeugwechsel halten.</translation>
    </message>
    <message>
        <source>Stopped at a tool change.</source>
        <translation>Bei einem Werkzeugwechsel angehalten.</translation>
    </message>
    <message>
        <source>M0 or M1</source>
        <translation>M0 oder M1</translation>
    </message>
    <message>
        <source>Stop at M0, M1 or M60.</source>
        <translation>Bei M0, M1 oder M60 halten.</translation>
    </message>
    <message>
        <source>Program stop (M0, M1 or M60).</source>
        <translation>Programmhalt (M0, M1 oder M60).</translation>
    </message>
    <message>
        <source>Z below</source>
        <translation>Z unter</translation>
    </message>
    <message>
        <source>Stop before a block that goes below a height.</source>
        <translation>Vor einem Satz halten, der unter eine Höhe fährt.</translation>
    </message>
    <message>
        <source>Stopped before going below Z {}.</source>
        <translation>Vor der Fahrt unter Z {} angehalten.</translation>
    </message>
    <message>
        <source>First contact</source>
        <translation>Erster Kontakt</translation>
    </message>
    <message>
        <source>Stop after the first block of each tool that removes material.</source>
        <translation>Nach dem ersten Satz jedes Werkzeugs halten, der Material abträgt.</translation>
    </message>
    <message>
        <source>Stopped after the first contact of the tool.</source>
        <translation>Nach dem ersten Kontakt des Werkzeugs angehalten.</translation>
    </message>
    <message>
        <source>On finding</source>
        <translation>Bei Befund</translation>
    </message>
    <message>
        <source>Stop after a block with a finding.</source>
        <translation>Nach einem Satz mit Befund halten.</translation>
    </message>
    <message>
        <source>Stopped after a block with a finding.</source>
        <translation>Nach einem Satz mit Befund angehalten.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Stop before a block where a condition becomes true.</source>
        <translation>Vor einem Satz halten, bei dem eine Bedingung wahr wird.</translation>
    </message>
    <message>
        <source>Breakpoint: {}.</source>
        <translation>Haltepunkt: {}.</translation>
    </message>
    <message>
        <source>position X at the end of the motion, mm</source>
        <translation>Position X am Ende der Bewegung, mm</translation>
    </message>
    <message>
        <source>position Y at the end of the motion, mm</source>
        <translation>Position Y am Ende der Bewegung, mm</translation>
    </message>
    <message>
        <source>position Z at the end of the motion, mm</source>
        <translation>Position Z am Ende der Bewegung, mm</translation>
    </message>
    <message>
        <source>feed, mm/min; 0 at rapid</source>
        <translation>Vorschub, mm/min; 0 im Eilgang</translation>
    </message>
    <message>
        <source>spindle speed, rpm</source>
        <translation>Spindeldrehzahl, 1/min</translation>
    </message>
    <message>
        <source>tool in the spindle</source>
        <translation>Werkzeug in der Spindel</translation>
    </message>
    <message>
        <source>number of the block, as the timeline counts</source>
        <translation>Nummer des Satzes, wie die Zeitleiste zählt</translation>
    </message>
    <message>
        <source>line of the program</source>
        <translation>Zeile des Programms</translation>
    </message>
    <message>
        <source>Column {}: a number or one of the letters X Y Z F S T N L is expected here.</source>
        <translation>Spalte {}: Hier wird eine Zahl oder einer der Buchstaben X Y Z F S T N L erwartet.</translation>
    </message>
    <message>
        <source>Column {}: one of &lt; &lt;= &gt; &gt;= == != is expected here.</source>
        <translation>Spalte {}: Hier wird eines von &lt; &lt;= &gt; &gt;= == != erwartet.</translation>
    </message>
    <message>
        <source>Column {}: &amp;&amp; or || is expected here.</source>
        <translation>Spalte {}: Hier wird &amp;&amp; oder || erwartet.</translation>
    </message>
    <message>
        <source>Column {}: a closing parenthesis is expected here.</source>
        <translation>Spalte {}: Hier wird eine schließende Klammer erwartet.</translation>
    </message>
    <message>
        <source>Column {}: the parentheses are nested too deeply.</source>
        <translation>Spalte {}: Die Klammern sind zu tief verschachtelt.</translation>
    </message>
    <message>
        <source>A condition has {} characters at most.</source>
        <translation>Eine Bedingung hat höchstens {} Zeichen.</translation>
    </message>
    <message>
        <source>Unknown fixture shape</source>
        <translation>Unbekannte Form des Spannmittels</translation>
    </message>
    <message>
        <source>Unknown fixture key</source>
        <translation>Unbekannter Schlüssel des Spannmittels</translation>
    </message>
    <message>
        <source>The shape of the fixture has no &quot;{}&quot;; it has {}.</source>
        <translation>Die Form des Spannmittels hat kein „{}“; sie hat {}.</translation>
    </message>
    <message>
        <source>Invalid fixture value</source>
        <translation>Ungültiger Wert des Spannmittels</translation>
    </message>
    <message>
        <source>&quot;{}&quot; of the fixture must be a number from {} to {}.</source>
        <translation>„{}“ des Spannmittels muss eine Zahl von {} bis {} sein.</translation>
    </message>
    <message>
        <source>Fixture without a name</source>
        <translation>Spannmittel ohne Namen</translation>
    </message>
    <message>
        <source>The fixture needs a name, as in NAME=SHAPE:key=value.</source>
        <translation>Das Spannmittel braucht einen Namen, wie in NAME=FORM:Schlüssel=Wert.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; is not a fixture: {}</source>
        <translation>Das Feld „{}“ ist kein Spannmittel: {}</translation>
    </message>
    <message>
        <source>The unconfirmed tool moves sideways in material, {} mm deep, but only cuts along its axis.</source>
        <translation>Das unbestätigte Werkzeug fährt seitlich durch Material, {} mm tief, schneidet aber nur längs seiner Achse.</translation>
    </message>
    <message>
        <source>Confirm the tool in the tool table, or choose another shape.</source>
        <translation>Bestätigen Sie das Werkzeug in der Werkzeugtabelle, oder wählen Sie eine andere Form.</translation>
    </message>
    <message>
        <source>Spindle never turns</source>
        <translation>Spindel dreht nie</translation>
    </message>
    <message>
        <source>The cutter cuts {} mm deep, but the program never turns the spindle at a speed.</source>
        <translation>Der Fräser fräst {} mm tief, aber das Programm lässt die Spindel nie mit einer Drehzahl laufen.</translation>
    </message>
    <message>
        <source>Program M3 with a speed S, or make sure that the spindle turns.</source>
        <translation>Programmieren Sie M3 mit einer Drehzahl S, oder stellen Sie sicher, dass die Spindel dreht.</translation>
    </message>
    <message>
        <source>Fixture collision</source>
        <translation>Kollision mit Spannmittel</translation>
    </message>
    <message>
        <source>The tool collides with the fixture &quot;{3}&quot;, {1} mm deep.</source>
        <translation>Das Werkzeug kollidiert mit dem Spannmittel „{3}“, {1} mm tief.</translation>
    </message>
    <message>
        <source>Move the fixture, or retract higher before the tool passes it.</source>
        <translation>Versetzen Sie das Spannmittel, oder fahren Sie höher frei, bevor das Werkzeug an ihm vorbeifährt.</translation>
    </message>
    <message>
        <source>Fixture too near</source>
        <translation>Spannmittel zu nah</translation>
    </message>
    <message>
        <source>The tool passes nearer than {2} mm to the fixture &quot;{3}&quot;, by {1} mm.</source>
        <translation>Das Werkzeug fährt näher als {2} mm an dem Spannmittel „{3}“ vorbei, um {1} mm zu nah.</translation>
    </message>
    <message>
        <source>Move the fixture, retract higher, or allow less clearance.</source>
        <translation>Versetzen Sie das Spannmittel, fahren Sie höher frei, oder erlauben Sie weniger Abstand.</translation>
    </message>
    <message>
        <source>Rapid close to stock</source>
        <translation>Eilgang nah am Rohteil</translation>
    </message>
    <message>
        <source>The rapid move passes the stock {} mm closer than the clearance of {} mm.</source>
        <translation>Der Eilgang fährt um {} mm näher am Rohteil vorbei, als es der Sicherheitsabstand von {} mm erlaubt.</translation>
    </message>
    <message>
        <source>Retract higher before the rapid, or reduce rapidClearance.</source>
        <translation>Fahren Sie vor dem Eilgang höher frei, oder verkleinern Sie rapidClearance.</translation>
    </message>
    <message>
        <source>Axial depth too large</source>
        <translation>Schnitttiefe zu groß</translation>
    </message>
    <message>
        <source>The axial depth of cut of {} mm is above the maximum of the tool, {} mm.</source>
        <translation>Die Schnitttiefe von {} mm liegt über dem Höchstwert des Werkzeugs, {} mm.</translation>
    </message>
    <message>
        <source>Cut in shallower passes, or choose another tool.</source>
        <translation>Schneiden Sie in flacheren Durchgängen, oder wählen Sie ein anderes Werkzeug.</translation>
    </message>
    <message>
        <source>Radial engagement too large</source>
        <translation>Eingriffsbreite zu groß</translation>
    </message>
    <message>
        <source>The radial engagement of {} mm is above the maximum of the tool, {} mm.</source>
        <translation>Die Eingriffsbreite von {} mm liegt über dem Höchstwert des Werkzeugs, {} mm.</translation>
    </message>
    <message>
        <source>Reduce the stepover, clear corners first, or choose another tool.</source>
        <translation>Verkleinern Sie die Zustellung, räumen Sie Ecken vorher aus, oder wählen Sie ein anderes Werkzeug.</translation>
    </message>
    <message>
        <source>Radial engagement jumps</source>
        <translation>Eingriffsbreite springt</translation>
    </message>
    <message>
        <source>From one block to the next the radial engagement more than doubles, to {} mm; the maximum of the tool is {} mm.</source>
        <translation>Von einem Satz zum nächsten steigt die Eingriffsbreite auf mehr als das Doppelte, auf {} mm; der Höchstwert des Werkzeugs ist {} mm.</translation>
    </message>
    <message>
        <source>Round the corner, or clear it first.</source>
        <translation>Runden Sie die Ecke, oder räumen Sie sie vorher aus.</translation>
    </message>
    <message>
        <source>Slot of full width</source>
        <translation>Nut in voller Breite</translation>
    </message>
    <message>
        <source>The tool cuts {} mm wide, a slot of its full diameter, {} mm; no radial limit is stated for it.</source>
        <translation>Das Werkzeug schneidet {} mm breit, eine Nut in seinem vollen Durchmesser, {} mm; für die Eingriffsbreite ist kein Grenzwert angegeben.</translation>
    </message>
    <message>
        <source>State maxae for the tool if it may not, or turn this rule off.</source>
        <translation>Geben Sie maxae für das Werkzeug an, wenn es das nicht darf, oder schalten Sie diese Regel aus.</translation>
    </message>
    <message>
        <source>Chips too thick</source>
        <translation>Späne zu dick</translation>
    </message>
    <message>
        <source>The chip thickness of {} mm is above the maximum of the tool, {} mm.</source>
        <translation>Die Spandicke von {} mm liegt über dem Höchstwert des Werkzeugs, {} mm.</translation>
    </message>
    <message>
        <source>Reduce the feed rate, or raise the spindle speed.</source>
        <translation>Verringern Sie den Vorschub, oder erhöhen Sie die Drehzahl.</translation>
    </message>
    <message>
        <source>Surface speed too high</source>
        <translation>Schnittgeschwindigkeit zu hoch</translation>
    </message>
    <message>
        <source>The surface speed of {} m/min is above the maximum of the tool, {} m/min.</source>
        <translation>Die Schnittgeschwindigkeit von {} m/min liegt über dem Höchstwert des Werkzeugs, {} m/min.</translation>
    </message>
    <message>
        <source>Reduce the spindle speed.</source>
        <translation>Verringern Sie die Drehzahl.</translation>
    </message>
    <message>
        <source>Removal rate too high</source>
        <translation>Zeitspanvolumen zu groß</translation>
    </message>
    <message>
        <source>The tool removes {} cm³/min; its maximum is {} cm³/min.</source>
        <translation>Das Werkzeug trägt {} cm³/min ab; sein Höchstwert ist {} cm³/min.</translation>
    </message>
    <message>
        <source>Reduce the feed rate, the depth or the stepover.</source>
        <translation>Verringern Sie Vorschub, Tiefe oder Zustellung.</translation>
    </message>
    <message>
        <source>Feed above tool maximum</source>
        <translation>Vorschub über Höchstwert des Werkzeugs</translation>
    </message>
    <message>
        <source>The tool cuts at a feed rate of {} mm/min; its maximum is {} mm/min.</source>
        <translation>Das Werkzeug schneidet mit einem Vorschub von {} mm/min; sein Höchstwert ist {} mm/min.</translation>
    </message>
    <message>
        <source>Reduce F, or correct maxfeed of the tool.</source>
        <translation>Verringern Sie F, oder korrigieren Sie maxfeed des Werkzeugs.</translation>
    </message>
    <message>
        <source>Spindle above tool maximum</source>
        <translation>Drehzahl über Höchstwert des Werkzeugs</translation>
    </message>
    <message>
        <source>The tool turns at {} rpm; its maximum is {} rpm.</source>
        <translation>Das Werkzeug dreht mit {} 1/min; sein Höchstwert ist {} 1/min.</translation>
    </message>
    <message>
        <source>Reduce S, or correct maxrpm of the tool.</source>
        <translation>Verringern Sie S, oder korrigieren Sie maxrpm des Werkzeugs.</translation>
    </message>
    <message>
        <source>Spindle speed too high</source>
        <translation>Drehzahl zu hoch</translation>
    </message>
    <message>
        <source>The spindle speed of {} rpm is above the maximum of the machine, {} rpm.</source>
        <translation>Die Drehzahl von {} 1/min liegt über dem Höchstwert der Maschine, {} 1/min.</translation>
    </message>
    <message>
        <source>Reduce S, or correct the machine values.</source>
        <translation>Verringern Sie S, oder korrigieren Sie die Maschinenwerte.</translation>
    </message>
    <message>
        <source>Ramp too steep</source>
        <translation>Rampe zu steil</translation>
    </message>
    <message>
        <source>The tool goes down into material at {}°; its steepest ramp is {}°.</source>
        <translation>Das Werkzeug fährt mit {}° ins Material; seine steilste Rampe ist {}°.</translation>
    </message>
    <message>
        <source>Lengthen the ramp or the helix, or drill a hole for the tool first.</source>
        <translation>Verlängern Sie die Rampe oder die Wendel, oder bohren Sie zuerst ein Loch für das Werkzeug.</translation>
    </message>
    <message>
        <source>Tap out of step</source>
        <translation>Gewindebohrer nicht synchron</translation>
    </message>
    <message>
        <source>The tap moves at a feed rate of {} mm/min; its pitch and the spindle speed need {} mm/min.</source>
        <translation>Der Gewindebohrer fährt mit einem Vorschub von {} mm/min; Steigung und Drehzahl verlangen {} mm/min.</translation>
    </message>
    <message>
        <source>Program F as pitch times spindle speed, or the pitch in G95.</source>
        <translation>Programmieren Sie F als Steigung mal Drehzahl, oder die Steigung in G95.</translation>
    </message>
    <message>
        <source>Tap not reversed</source>
        <translation>Gewindebohrer nicht umgekehrt</translation>
    </message>
    <message>
        <source>The tap is retracted from a thread {} mm deep without reversing the spindle.</source>
        <translation>Der Gewindebohrer fährt aus einem {} mm tiefen Gewinde, ohne dass die Spindel umkehrt.</translation>
    </message>
    <message>
        <source>Tap with G84, G74 or G33.1; turn this rule off for a reversing tap holder.</source>
        <translation>Bohren Sie Gewinde mit G84, G74 oder G33.1; schalten Sie diese Regel für ein umkehrendes Futter aus.</translation>
    </message>
    <message>
        <source>Tool differs from comment</source>
        <translation>Werkzeug weicht vom Kommentar ab</translation>
    </message>
    <message>
        <source>The comment describes T{} as ⌀ {} mm; the tool table has ⌀ {} mm.</source>
        <translation>Der Kommentar beschreibt T{} mit ⌀ {} mm; die Werkzeugtabelle hat ⌀ {} mm.</translation>
    </message>
    <message>
        <source>Load the tool that the program was made for, or correct the comment.</source>
        <translation>Laden Sie das Werkzeug, für das das Programm gemacht wurde, oder korrigieren Sie den Kommentar.</translation>
    </message>
    <message>
        <source>The comment describes T{} as “{}”; the tool table has “{}”.</source>
        <translation>Der Kommentar beschreibt T{} als „{}“; die Werkzeugtabelle hat „{}“.</translation>
    </message>
    <message>
        <source>Maximum feed rate and spindle speed of the machine</source>
        <translation>Größter Vorschub und größte Drehzahl der Maschine</translation>
    </message>
    <message>
        <source>Maximum spindle speed of the machine</source>
        <translation>Größte Drehzahl der Maschine</translation>
    </message>
    <message>
        <source>&quot;{}&quot; of the machine must be a number from {} to {}.</source>
        <translation>„{}“ der Maschine muss eine Zahl von {} bis {} sein.</translation>
    </message>
    <message>
        <source>A machine has no &quot;{}&quot;; it has {}.</source>
        <translation>Eine Maschine hat kein „{}“; sie hat {}.</translation>
    </message>
    <message>
        <source>Rapid traverse X/Y</source>
        <translation>Eilgang X/Y</translation>
    </message>
    <message>
        <source>Speed of X and of Y at rapid.</source>
        <translation>Eilganggeschwindigkeit von X und von Y.</translation>
    </message>
    <message>
        <source>Rapid traverse Z</source>
        <translation>Eilgang Z</translation>
    </message>
    <message>
        <source>Speed of Z at rapid.</source>
        <translation>Eilganggeschwindigkeit von Z.</translation>
    </message>
    <message>
        <source>Maximum feed rate</source>
        <translation>Maximaler Vorschub</translation>
    </message>
    <message>
        <source>The machine limits the feed rate to this, whatever F says.</source>
        <translation>Die Maschine begrenzt den Vorschub auf diesen Wert, unabhängig von F.</translation>
    </message>
    <message>
        <source>Acceleration X, Y</source>
        <translation>Beschleunigung X, Y</translation>
    </message>
    <message>
        <source>Acceleration of X and of Y.</source>
        <translation>Beschleunigung von X und von Y.</translation>
    </message>
    <message>
        <source>Acceleration Z</source>
        <translation>Beschleunigung Z</translation>
    </message>
    <message>
        <source>Acceleration of Z.</source>
        <translation>Beschleunigung von Z.</translation>
    </message>
    <message>
        <source>Cornering tolerance</source>
        <translation>Eckentoleranz</translation>
    </message>
    <message>
        <source>Largest deviation of a rounded corner; 0: exact stop at each corner.</source>
        <translation>Größte Abweichung an einer verrundeten Ecke; 0: Genauhalt an jeder Ecke.</translation>
    </message>
    <message>
        <source>Tool change time, chip to chip.</source>
        <translation>Werkzeugwechselzeit, Span zu Span.</translation>
    </message>
    <message>
        <source>There is not enough memory for the detail region.</source>
        <translation>Der Speicher reicht nicht für den Detailbereich.</translation>
    </message>
    <message>
        <source>The detail region could not be cut: {}.</source>
        <translation>Der Detailbereich ließ sich nicht fräsen: {}.</translation>
    </message>
    <message>
        <source>The block that cut this point could not be found: {}.</source>
        <translation>Der Satz, der diesen Punkt gefräst hat, ließ sich nicht finden: {}.</translation>
    </message>
    <message>
        <source>“{}” does not begin with a tool number from {} to {}, as in {}.</source>
        <translation>„{}“ beginnt nicht mit einer Werkzeugnummer von {} bis {}, wie in {}.</translation>
    </message>
    <message>
        <source>A tool needs a number, a whole one from {} to {}.</source>
        <translation>Ein Werkzeug braucht eine Nummer, eine ganze Zahl von {} bis {}.</translation>
    </message>
    <message>
        <source>The source of a tool is &quot;given&quot;, &quot;comment&quot; or &quot;assumed&quot;.</source>
        <translation>Die Herkunft eines Werkzeugs ist „given“, „comment“ oder „assumed“.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; and the fields minX, minY, topZ cannot be used together; they are the same position.</source>
        <translation>Das Feld „{}“ und die Felder minX, minY, topZ dürfen nicht zusammen verwendet werden; sie geben dieselbe Position an.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a tool number; these are whole numbers from {} to {}.</source>
        <translation>„{}“ ist keine Werkzeugnummer; Werkzeugnummern sind ganze Zahlen von {} bis {}.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be a list of whole numbers from 0 to {}.</source>
        <translation>Das Feld „{}“ muss eine Liste ganzer Zahlen von 0 bis {} sein.</translation>
    </message>
    <message>
        <source>spindle number</source>
        <translation>Spindelnummer</translation>
    </message>
    <message>
        <source>a Heidenhain conversational program</source>
        <translation>ein Heidenhain-Klartextprogramm</translation>
    </message>
    <message>
        <source>a Heidenhain DIN/ISO program</source>
        <translation>ein Heidenhain-DIN/ISO-Programm</translation>
    </message>
    <message>
        <source>a Siemens Sinumerik program</source>
        <translation>ein Siemens-Sinumerik-Programm</translation>
    </message>
    <message>
        <source>an Okuma OSP program</source>
        <translation>ein Okuma-OSP-Programm</translation>
    </message>
    <message>
        <source>a WinCNC program</source>
        <translation>ein WinCNC-Programm</translation>
    </message>
    <message>
        <source>a ShopBot program</source>
        <translation>ein ShopBot-Programm</translation>
    </message>
    <message>
        <source>a lathe program</source>
        <translation>ein Drehprogramm</translation>
    </message>
    <message>
        <source>a 3D printer program</source>
        <translation>ein 3D-Drucker-Programm</translation>
    </message>
    <message>
        <source>an APT or CL data file</source>
        <translation>eine APT- oder CL-Datei</translation>
    </message>
    <message>
        <source>a Gerber file</source>
        <translation>eine Gerber-Datei</translation>
    </message>
    <message>
        <source>an Excellon drill file</source>
        <translation>eine Excellon-Bohrdatei</translation>
    </message>
    <message>
        <source>an HPGL plot file</source>
        <translation>eine HPGL-Plotdatei</translation>
    </message>
    <message>
        <source>a CAMotics project</source>
        <translation>ein CAMotics-Projekt</translation>
    </message>
    <message>
        <source>a Proveout job</source>
        <translation>ein Proveout-Auftrag</translation>
    </message>
    <message>
        <source>a JSON file</source>
        <translation>eine JSON-Datei</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>eine SVG-Zeichnung</translation>
    </message>
    <message>
        <source>an HTML page</source>
        <translation>eine HTML-Seite</translation>
    </message>
    <message>
        <source>an XML file</source>
        <translation>eine XML-Datei</translation>
    </message>
    <message>
        <source>an STL mesh</source>
        <translation>ein STL-Netz</translation>
    </message>
    <message>
        <source>an OBJ mesh</source>
        <translation>ein OBJ-Netz</translation>
    </message>
    <message>
        <source>a PLY mesh</source>
        <translation>ein PLY-Netz</translation>
    </message>
    <message>
        <source>a STEP model</source>
        <translation>ein STEP-Modell</translation>
    </message>
    <message>
        <source>a DXF drawing</source>
        <translation>eine DXF-Zeichnung</translation>
    </message>
    <message>
        <source>a PostScript file</source>
        <translation>eine PostScript-Datei</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>ein PDF-Dokument</translation>
    </message>
    <message>
        <source>a rich text document</source>
        <translation>ein Rich-Text-Dokument</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not an M code; write numbers from 0 to {}, for example 10, 11, 16.</source>
        <translation>„{}“ ist kein M-Befehl; Zahlen von 0 bis {} schreiben, zum Beispiel 10, 11, 16.</translation>
    </message>
    <message>
        <source>clamp of a rotary axis or pallet on</source>
        <translation>Klemmung einer Drehachse oder Palette ein</translation>
    </message>
    <message>
        <source>clamp of a rotary axis or pallet off</source>
        <translation>Klemmung einer Drehachse oder Palette aus</translation>
    </message>
    <message>
        <source>low spindle gear</source>
        <translation>niedrige Getriebestufe der Spindel</translation>
    </message>
    <message>
        <source>high spindle gear</source>
        <translation>hohe Getriebestufe der Spindel</translation>
    </message>
    <message>
        <source>clamp of the B axis on</source>
        <translation>Klemmung der B-Achse ein</translation>
    </message>
    <message>
        <source>clamp of the B axis off</source>
        <translation>Klemmung der B-Achse aus</translation>
    </message>
    <message>
        <source>brake of the 4th axis on</source>
        <translation>Bremse der 4. Achse ein</translation>
    </message>
    <message>
        <source>brake of the 4th axis off</source>
        <translation>Bremse der 4. Achse aus</translation>
    </message>
    <message>
        <source>brake of the 5th axis on</source>
        <translation>Bremse der 5. Achse ein</translation>
    </message>
    <message>
        <source>brake of the 5th axis off</source>
        <translation>Bremse der 5. Achse aus</translation>
    </message>
    <message>
        <source>pallet unclamped, door open</source>
        <translation>Palette gelöst, Tür offen</translation>
    </message>
    <message>
        <source>pallet clamped, door closed</source>
        <translation>Palette geklemmt, Tür geschlossen</translation>
    </message>
    <message>
        <source>chip conveyor on</source>
        <translation>Späneförderer ein</translation>
    </message>
    <message>
        <source>chip conveyor off</source>
        <translation>Späneförderer aus</translation>
    </message>
    <message>
        <source>coolant nozzle one step on</source>
        <translation>Kühlmitteldüse einen Schritt weiter</translation>
    </message>
    <message>
        <source>coolant nozzle one step back</source>
        <translation>Kühlmitteldüse einen Schritt zurück</translation>
    </message>
    <message>
        <source>pallet part ready</source>
        <translation>Werkstück auf der Palette bereit</translation>
    </message>
    <message>
        <source>air through the tool on</source>
        <translation>Luft durch das Werkzeug ein</translation>
    </message>
    <message>
        <source>air through the tool off</source>
        <translation>Luft durch das Werkzeug aus</translation>
    </message>
    <message>
        <source>display off</source>
        <translation>Anzeige aus</translation>
    </message>
    <message>
        <source>display on</source>
        <translation>Anzeige ein</translation>
    </message>
    <message>
        <source>door open</source>
        <translation>Tür offen</translation>
    </message>
    <message>
        <source>door closed</source>
        <translation>Tür geschlossen</translation>
    </message>
    <message>
        <source>air jet on</source>
        <translation>Blasluft ein</translation>
    </message>
    <message>
        <source>air jet off</source>
        <translation>Blasluft aus</translation>
    </message>
    <message>
        <source>coolant through the spindle on</source>
        <translation>Kühlmittel durch die Spindel ein</translation>
    </message>
    <message>
        <source>coolant through the spindle off</source>
        <translation>Kühlmittel durch die Spindel aus</translation>
    </message>
    <message>
        <source>image shown on the display</source>
        <translation>Bild auf dem Bildschirm anzeigen</translation>
    </message>
    <message>
        <source>image on the display closed</source>
        <translation>Bild auf dem Bildschirm schließen</translation>
    </message>
    <message>
        <source>spindle speed variation on</source>
        <translation>Drehzahlvariation der Spindel ein</translation>
    </message>
    <message>
        <source>spindle speed variation off</source>
        <translation>Drehzahlvariation der Spindel aus</translation>
    </message>
    <message>
        <source>mist extractor on</source>
        <translation>Nebelabsaugung ein</translation>
    </message>
    <message>
        <source>mist extractor off</source>
        <translation>Nebelabsaugung aus</translation>
    </message>
    <message>
        <source>This is {} (line {}: {}), which Proveout does not read.</source>
        <translation>Dies ist {} (Zeile {}: {}); das liest Proveout nicht.</translation>
    </message>
    <message>
        <source>This is {} (line {}: {}), not an NC program.</source>
        <translation>Dies ist {} (Zeile {}: {}), kein NC-Programm.</translation>
    </message>
    <message>
        <source>Open the program that the machine would run; if this is it, choose its dialect.</source>
        <translation>Das Programm öffnen, das die Maschine ausführen würde; ist es dieses, seinen Dialekt wählen.</translation>
    </message>
    <message>
        <source>If it moves no axis (a clamp, a door, air), add it to the ignored M codes of the setup; until then, results after this block are unverified.</source>
        <translation>Bewegt er keine Achse (Klemmung, Tür, Luft), in die ignorierten M-Befehle der Aufspannung aufnehmen; bis dahin sind die Ergebnisse nach diesem Satz ungeprüft.</translation>
    </message>
    <message>
        <source>{} ({}) moves no axis and is ignored ({}×, line {}).</source>
        <translation>{} ({}) bewegt keine Achse und wird ignoriert ({}×, Zeile {}).</translation>
    </message>
    <message>
        <source>The machine builder defines M codes; check this one where it matters.</source>
        <translation>M-Befehle legt der Maschinenhersteller fest; diesen prüfen, wo es darauf ankommt.</translation>
    </message>
    <message>
        <source>{} is ignored because the setup lists it ({}×, line {}).</source>
        <translation>{} wird ignoriert, weil die Aufspannung es aufführt ({}×, Zeile {}).</translation>
    </message>
    <message>
        <source>Remove it from the ignored M codes if it moves an axis.</source>
        <translation>Aus den ignorierten M-Befehlen entfernen, falls er eine Achse bewegt.</translation>
    </message>
    <message>
        <source>{} ({}) is executed although the setup lists it as ignored.</source>
        <translation>{} ({}) wird ausgeführt, obwohl die Aufspannung es als ignoriert aufführt.</translation>
    </message>
    <message>
        <source>Remove it from the ignored M codes: only codes without a known effect can be ignored.</source>
        <translation>Aus den ignorierten M-Befehlen entfernen: Nur Befehle ohne bekannte Wirkung lassen sich ignorieren.</translation>
    </message>
    <message>
        <source>There is no spindle {}: the machine has one, $0.</source>
        <translation>Es gibt keine Spindel {}: Die Maschine hat eine, $0.</translation>
    </message>
    <message>
        <source>Write $0, or leave the word out; this block is skipped.</source>
        <translation>$0 schreiben oder das Wort weglassen; dieser Satz wird übersprungen.</translation>
    </message>
    <message>
        <source>Writing #5220 selects no work offset.</source>
        <translation>Das Beschreiben von #5220 wählt keine Nullpunktverschiebung.</translation>
    </message>
    <message>
        <source>Select it with G54 to G59.3, which write #5220 themselves.</source>
        <translation>Mit G54 bis G59.3 wählen, die #5220 selbst beschreiben.</translation>
    </message>
    <message>
        <source>G43.2 has both H and axis words.</source>
        <translation>G43.2 hat sowohl H als auch Achswörter.</translation>
    </message>
    <message>
        <source>Write two blocks; the offset in force is kept.</source>
        <translation>Zwei Sätze schreiben; die aktive Korrektur bleibt.</translation>
    </message>
    <message>
        <source>LinuxCNC 2.9 mixes up the axes of a tapping cycle in {}: the tool feeds to another place than the hole bottom.</source>
        <translation>LinuxCNC 2.9 verwechselt die Achsen eines Gewindebohrzyklus in {}: Das Werkzeug fährt im Vorschub an eine andere Stelle als den Bohrungsgrund.</translation>
    </message>
    <message>
        <source>Tap in G17, or use G33.1.</source>
        <translation>Das Gewinde in G17 bohren oder G33.1 verwenden.</translation>
    </message>
    <message>
        <source>{} rotates the work offset while G92 or G52 is active: LinuxCNC then assumes a wrong tool position.</source>
        <translation>{} dreht die Nullpunktverschiebung, während G92 oder G52 aktiv ist: LinuxCNC nimmt danach eine falsche Werkzeugposition an.</translation>
    </message>
    <message>
        <source>Cancel the shift with G92.1 first, and set it again afterwards.</source>
        <translation>Die Verschiebung vorher mit G92.1 aufheben und danach neu setzen.</translation>
    </message>
    <message>
        <source>The control assumes another tool position than the real one at the start of this arc.</source>
        <translation>Am Anfang dieses Kreisbogens nimmt die Steuerung eine andere Werkzeugposition an als die tatsächliche.</translation>
    </message>
    <message>
        <source>Program a straight move before the arc; the arc is skipped.</source>
        <translation>Vor dem Kreisbogen eine Gerade programmieren; der Kreisbogen wird übersprungen.</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>ein PNG-Bild</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>ein JPEG-Bild</translation>
    </message>
    <message>
        <source>a GIF picture</source>
        <translation>ein GIF-Bild</translation>
    </message>
    <message>
        <source>a ZIP archive, as 3MF, FreeCAD and office files are</source>
        <translation>ein ZIP-Archiv, wie es 3MF-, FreeCAD- und Office-Dateien sind</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <translation>ein gzip-Archiv</translation>
    </message>
    <message>
        <source>a 7z archive</source>
        <translation>ein 7z-Archiv</translation>
    </message>
    <message>
        <source>an office or CAD document</source>
        <translation>ein Office- oder CAD-Dokument</translation>
    </message>
    <message>
        <source>an executable file</source>
        <translation>eine ausführbare Datei</translation>
    </message>
    <message>
        <source>This is {}, not an NC program.</source>
        <translation>Dies ist {}, kein NC-Programm.</translation>
    </message>
    <message>
        <source>The grid spacing of {} mm is too coarse for T{} (⌀{} mm): it has only {} points across it.</source>
        <translation>Die Rasterweite von {} mm ist zu grob für T{} (⌀{} mm): Auf den Durchmesser kommen nur {} Punkte.</translation>
    </message>
    <message>
        <source>Choose a finer grid, or the automatic one; see details with View, Magnifier, or in a smaller stock.</source>
        <translation>Ein feineres Gitter oder das automatische wählen; Einzelheiten mit Ansicht, Detaillupe oder in einem kleineren Rohteil ansehen.</translation>
    </message>
    <message>
        <source>See details with View, Magnifier, or in a smaller stock, or enter a finer grid spacing.</source>
        <translation>Einzelheiten mit Ansicht, Detaillupe oder in einem kleineren Rohteil ansehen oder eine kleinere Rasterweite eingeben.</translation>
    </message>
    <message>
        <source>Confirm the sizes of the tool in the tool table, or correct them.</source>
        <translation>Die Maße des Werkzeugs in der Werkzeugtabelle bestätigen oder berichtigen.</translation>
    </message>
    <message>
        <source>Rapid move cuts stock ({} mm deep) with the unconfirmed tool T{}.</source>
        <translation>Eilgang fräst Rohteil ({} mm tief) mit dem unbestätigten Werkzeug T{}.</translation>
    </message>
    <message>
        <source>The cut is {} mm deep, beyond the flutes of the unconfirmed tool T{}.</source>
        <translation>Der Schnitt ist {} mm tief, tiefer als die Schneidenlänge des unbestätigten Werkzeugs T{}.</translation>
    </message>
    <message>
        <source>{} mm of stock meet the neck of the unconfirmed tool T{}.</source>
        <translation>{} mm Rohteil treffen auf den Hals des unbestätigten Werkzeugs T{}.</translation>
    </message>
    <message>
        <source>T{} is read from a comment (⌀ {} mm {}); it is not confirmed.</source>
        <translation>T{} ist aus einem Kommentar gelesen (⌀ {} mm {}) und nicht bestätigt.</translation>
    </message>
    <message>
        <source>T{} is read from a comment (⌀ {} mm {}; assumed: {}); it is not confirmed.</source>
        <translation>T{} ist aus einem Kommentar gelesen (⌀ {} mm {}; angenommen: {}) und nicht bestätigt.</translation>
    </message>
    <message>
        <source>The sizes of T{} are assumed (⌀ {} mm {}); they are not confirmed.</source>
        <translation>Die Maße von T{} sind angenommen (⌀ {} mm {}) und nicht bestätigt.</translation>
    </message>
    <message>
        <source>The program cuts before it calls a tool; T{} is assumed to be in the spindle.</source>
        <translation>Das Programm fräst, bevor es ein Werkzeug aufruft; angenommen wird T{} in der Spindel.</translation>
    </message>
    <message>
        <source>Set the tool at start in the setup if this is the right one.</source>
        <translation>In der Aufspannung als Werkzeug am Anfang setzen, falls dies das richtige ist.</translation>
    </message>
    <message>
        <source>T{} is not in the tool table; its moves are not simulated.</source>
        <translation>T{} steht nicht in der Werkzeugtabelle; seine Bewegungen werden nicht simuliert.</translation>
    </message>
    <message>
        <source>Define it in the tool table.</source>
        <translation>In der Werkzeugtabelle definieren.</translation>
    </message>
    <message>
        <source>The program cuts before it calls a tool; moves are not simulated until it does.</source>
        <translation>Das Programm fräst, bevor es ein Werkzeug aufruft; bis dahin werden Bewegungen nicht simuliert.</translation>
    </message>
    <message>
        <source>Set the tool at start in the setup, or program T and M6 before the first cut.</source>
        <translation>In der Aufspannung das Werkzeug am Anfang setzen oder T und M6 vor dem ersten Schnitt programmieren.</translation>
    </message>
    <message>
        <source>T{} leaves the spindle empty; its moves are not simulated.</source>
        <translation>T{} lässt die Spindel leer; seine Bewegungen werden nicht simuliert.</translation>
    </message>
    <message>
        <source>Define T0 in the tool table if it is a cutter.</source>
        <translation>T0 in der Werkzeugtabelle definieren, falls es ein Fräser ist.</translation>
    </message>
    <message>
        <source>Min X</source>
        <translation>Min. X</translation>
    </message>
    <message>
        <source>Program coordinate of the left side of the stock.</source>
        <translation>Programmkoordinate der linken Seite des Rohteils.</translation>
    </message>
    <message>
        <source>Min Y</source>
        <translation>Min. Y</translation>
    </message>
    <message>
        <source>Program coordinate of the front side of the stock.</source>
        <translation>Programmkoordinate der Vorderseite des Rohteils.</translation>
    </message>
    <message>
        <source>Top Z</source>
        <translation>Oberseite Z</translation>
    </message>
    <message>
        <source>Program coordinate of the top of the stock.</source>
        <translation>Programmkoordinate der Oberseite des Rohteils.</translation>
    </message>
    <message>
        <source>Grid spacing</source>
        <translation>Rasterweite</translation>
    </message>
    <message>
        <source>Distance between the points of the z-map; adjusted so that it divides the stock exactly.</source>
        <translation>Abstand der Punkte der Z-Map; so angepasst, dass er das Rohteil genau teilt.</translation>
    </message>
    <message>
        <source>Start position</source>
        <translation>Startposition</translation>
    </message>
    <message>
        <source>Program coordinates of the tool tip before the first block; unknown if not set.</source>
        <translation>Programmkoordinaten der Werkzeugspitze vor dem ersten Satz; unbekannt, wenn nicht gesetzt.</translation>
    </message>
    <message>
        <source>Tool at start</source>
        <translation>Werkzeug am Anfang</translation>
    </message>
    <message>
        <source>Tool in the spindle before the first tool change; 0 is an empty spindle, or T0 of the tool table.</source>
        <translation>Werkzeug in der Spindel vor dem ersten Werkzeugwechsel; 0 ist eine leere Spindel oder T0 der Werkzeugtabelle.</translation>
    </message>
    <message>
        <source>Check the size and position of the stock, and the work offset: the position of the stock is that of its top, not its bottom.</source>
        <translation>Größe und Position des Rohteils und die Nullpunktverschiebung prüfen: Die Position des Rohteils ist die seiner Oberseite, nicht seiner Unterseite.</translation>
    </message>
    <message>
        <source>The program never cuts the stock: its cutting moves are within {}, the stock within {}.</source>
        <translation>Das Programm fräst das Rohteil nie: Seine Vorschubbewegungen liegen in {}, das Rohteil in {}.</translation>
    </message>
    <message>
        <source>Cutting moves extend {} mm beyond the stock in {}, where it measures {} mm.</source>
        <translation>Vorschubbewegungen reichen in {2} um {1} mm über das Rohteil hinaus, das dort {3} mm misst.</translation>
    </message>
    <message>
        <source>The stock has no file yet; nothing is simulated.</source>
        <translation>Das Rohteil hat noch keine Datei; nichts wird simuliert.</translation>
    </message>
    <message>
        <source>The stock cannot be made from {}; nothing is simulated.</source>
        <translation>Das Rohteil lässt sich nicht aus {} bilden; nichts wird simuliert.</translation>
    </message>
    <message>
        <source>Choose the file of the stock, or another shape.</source>
        <translation>Die Datei des Rohteils oder eine andere Form wählen.</translation>
    </message>
    <message>
        <source>Unsaved changes are no longer backed up: {}.</source>
        <translation>Nicht gespeicherte Änderungen werden nicht mehr gesichert: {}.</translation>
    </message>
    <message>
        <source>Save under another name (File &gt; Save As).</source>
        <translation>Unter einem anderen Namen speichern (Datei &gt; Speichern unter).</translation>
    </message>
    <message>
        <source>The file has changed on disk; it was not overwritten.</source>
        <translation>Die Datei hat sich auf dem Datenträger geändert; sie wurde nicht überschrieben.</translation>
    </message>
    <message>
        <source>The backup of this session is damaged.</source>
        <translation>Die Sicherung dieser Sitzung ist beschädigt.</translation>
    </message>
    <message>
        <source>{} of {} facets are duplicates of another facet.</source>
        <translation>{} von {} Facetten sind Duplikate einer anderen Facette.</translation>
    </message>
    <message>
        <source>Export the part again as one closed solid.</source>
        <translation>Das Werkstück erneut als einen geschlossenen Körper exportieren.</translation>
    </message>
    <message>
        <source>The mesh is not closed: {} edges belong to only one facet.</source>
        <translation>Das Netz ist nicht geschlossen: {} Kanten gehören nur zu einer Facette.</translation>
    </message>
    <message>
        <source>The mesh is not manifold: {} edges belong to more than two facets.</source>
        <translation>Das Netz ist nicht mannigfaltig: {} Kanten gehören zu mehr als zwei Facetten.</translation>
    </message>
    <message>
        <source>The winding of the facets is inconsistent: it changes at {} edges.</source>
        <translation>Der Umlaufsinn der Facetten ist nicht einheitlich: Er wechselt an {} Kanten.</translation>
    </message>
    <message>
        <source>The mesh is inside out: {} of {} facets face inwards; they are taken as facing outwards.</source>
        <translation>Das Netz ist umgestülpt: {} von {} Facetten zeigen nach innen; sie gelten als nach außen gerichtet.</translation>
    </message>
    <message>
        <source>The mesh is only {} mm in size; in metres it would be {} mm.</source>
        <translation>Das Netz ist nur {} mm groß; in Metern wären es {} mm.</translation>
    </message>
    <message>
        <source>The mesh is {} mm in size; in micrometres it would be {} mm.</source>
        <translation>Das Netz ist {} mm groß; in Mikrometern wären es {} mm.</translation>
    </message>
    <message>
        <source>Export the part in millimetres; STL files have no unit.</source>
        <translation>Das Werkstück in Millimetern exportieren; STL-Dateien haben keine Einheit.</translation>
    </message>
    <message>
        <source>The program calls no tool; T{} is assumed to be in the spindle.</source>
        <translation>Das Programm ruft kein Werkzeug auf; angenommen wird T{} in der Spindel.</translation>
    </message>
    <message>
        <source>The program calls no tool; its moves are not simulated.</source>
        <translation>Das Programm ruft kein Werkzeug auf; seine Bewegungen werden nicht simuliert.</translation>
    </message>
    <message>
        <source>The stock file has changed on disk; the simulation still uses the version read before.</source>
        <translation>Die Rohteildatei hat sich auf dem Datenträger geändert; die Simulation verwendet noch die zuvor gelesene Version.</translation>
    </message>
    <message>
        <source>Reload the stock in the Setup panel, or keep the current version.</source>
        <translation>Das Rohteil unter „Aufspannung“ neu laden oder die aktuelle Version behalten.</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>1/min</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>{} ({}) moves no axis and is ignored ({}×, lines {}).</source>
        <translation>{} ({}) bewegt keine Achse und wird ignoriert ({}×, Zeilen {}).</translation>
    </message>
    <message>
        <source>{} is ignored because the setup lists it ({}×, lines {}).</source>
        <translation>{} wird ignoriert, weil die Aufspannung es aufführt ({}×, Zeilen {}).</translation>
    </message>
    <message>
        <source>Unexpected character</source>
        <translation>Unerwartetes Zeichen</translation>
    </message>
    <message>
        <source>Word without a value</source>
        <translation>Wort ohne Wert</translation>
    </message>
    <message>
        <source>Number with two signs</source>
        <translation>Zahl mit zwei Vorzeichen</translation>
    </message>
    <message>
        <source>Number with two points</source>
        <translation>Zahl mit zwei Punkten</translation>
    </message>
    <message>
        <source>Number out of range</source>
        <translation>Zahl außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>Comment not closed</source>
        <translation>Kommentar nicht geschlossen</translation>
    </message>
    <message>
        <source>Nested comment</source>
        <translation>Verschachtelter Kommentar</translation>
    </message>
    <message>
        <source>Duplicate word</source>
        <translation>Doppeltes Wort</translation>
    </message>
    <message>
        <source>Duplicate word, last used</source>
        <translation>Doppeltes Wort, letztes gilt</translation>
    </message>
    <message>
        <source>Too many codes in block</source>
        <translation>Zu viele Befehle im Satz</translation>
    </message>
    <message>
        <source>N word not first</source>
        <translation>N-Wort nicht am Satzanfang</translation>
    </message>
    <message>
        <source>Negative block number</source>
        <translation>Negative Satznummer</translation>
    </message>
    <message>
        <source>Block number too long</source>
        <translation>Satznummer zu lang</translation>
    </message>
    <message>
        <source>&quot;%&quot; not alone</source>
        <translation>„%“ nicht allein in der Zeile</translation>
    </message>
    <message>
        <source>Line too long</source>
        <translation>Zeile zu lang</translation>
    </message>
    <message>
        <source>Control codes skipped</source>
        <translation>Steuerzeichen übersprungen</translation>
    </message>
    <message>
        <source>Byte order mark</source>
        <translation>Byte-Order-Mark</translation>
    </message>
    <message>
        <source>CR line end</source>
        <translation>Zeilenende nur CR</translation>
    </message>
    <message>
        <source>No decimal point</source>
        <translation>Kein Dezimalpunkt</translation>
    </message>
    <message>
        <source>Expression nested too deeply</source>
        <translation>Ausdruck zu tief verschachtelt</translation>
    </message>
    <message>
        <source>Brackets nested too deeply</source>
        <translation>Klammern zu tief verschachtelt</translation>
    </message>
    <message>
        <source>Parameter not set</source>
        <translation>Parameter nicht gesetzt</translation>
    </message>
    <message>
        <source>Position not readable</source>
        <translation>Position nicht lesbar</translation>
    </message>
    <message>
        <source>Parameter number not whole</source>
        <translation>Parameternummer nicht ganzzahlig</translation>
    </message>
    <message>
        <source>Unknown parameter number</source>
        <translation>Unbekannte Parameternummer</translation>
    </message>
    <message>
        <source>Read-only parameter</source>
        <translation>Parameter nur lesbar</translation>
    </message>
    <message>
        <source>Name not closed</source>
        <translation>Name nicht geschlossen</translation>
    </message>
    <message>
        <source>Empty name</source>
        <translation>Leerer Name</translation>
    </message>
    <message>
        <source>Name too long</source>
        <translation>Name zu lang</translation>
    </message>
    <message>
        <source>Too many named parameters</source>
        <translation>Zu viele benannte Parameter</translation>
    </message>
    <message>
        <source>Bracket not closed</source>
        <translation>Klammer nicht geschlossen</translation>
    </message>
    <message>
        <source>Brackets missing</source>
        <translation>Klammern fehlen</translation>
    </message>
    <message>
        <source>Operator missing</source>
        <translation>Operator fehlt</translation>
    </message>
    <message>
        <source>Expression without a result</source>
        <translation>Ausdruck ohne Ergebnis</translation>
    </message>
    <message>
        <source>Second argument missing</source>
        <translation>Zweites Argument fehlt</translation>
    </message>
    <message>
        <source>EXISTS without a name</source>
        <translation>EXISTS ohne Namen</translation>
    </message>
    <message>
        <source>Incomplete assignment</source>
        <translation>Unvollständige Zuweisung</translation>
    </message>
    <message>
        <source>Undocumented modal variable</source>
        <translation>Nicht dokumentierte Modalvariable</translation>
    </message>
    <message>
        <source>Machine-dependent variable</source>
        <translation>Maschinenabhängige Variable</translation>
    </message>
    <message>
        <source>Variable assumed to be 0</source>
        <translation>Variable als 0 angenommen</translation>
    </message>
    <message>
        <source>Position unknown</source>
        <translation>Position unbekannt</translation>
    </message>
    <message>
        <source>#5220 written</source>
        <translation>#5220 beschrieben</translation>
    </message>
    <message>
        <source>Invalid O number</source>
        <translation>Ungültige O-Nummer</translation>
    </message>
    <message>
        <source>Unknown O-word keyword</source>
        <translation>Unbekanntes O-Wort-Schlüsselwort</translation>
    </message>
    <message>
        <source>O word not first</source>
        <translation>O-Wort nicht am Satzanfang</translation>
    </message>
    <message>
        <source>Text after O word</source>
        <translation>Text nach dem O-Wort</translation>
    </message>
    <message>
        <source>Unmatched O word</source>
        <translation>O-Wort ohne Gegenstück</translation>
    </message>
    <message>
        <source>Duplicate O label</source>
        <translation>Doppelte O-Marke</translation>
    </message>
    <message>
        <source>Continue in a do loop</source>
        <translation>continue in do-Schleife</translation>
    </message>
    <message>
        <source>Nested subprogram</source>
        <translation>Verschachteltes Unterprogramm</translation>
    </message>
    <message>
        <source>Condition missing</source>
        <translation>Bedingung fehlt</translation>
    </message>
    <message>
        <source>Subprogram not found</source>
        <translation>Unterprogramm nicht gefunden</translation>
    </message>
    <message>
        <source>Subprogram outside its folders</source>
        <translation>Unterprogramm außerhalb der Ordner</translation>
    </message>
    <message>
        <source>Subprogram not readable</source>
        <translation>Unterprogramm nicht lesbar</translation>
    </message>
    <message>
        <source>Subprogram not closed</source>
        <translation>Unterprogramm nicht geschlossen</translation>
    </message>
    <message>
        <source>Calls nested too deeply</source>
        <translation>Aufrufe zu tief verschachtelt</translation>
    </message>
    <message>
        <source>Too many arguments</source>
        <translation>Zu viele Argumente</translation>
    </message>
    <message>
        <source>Return outside a subprogram</source>
        <translation>Rücksprung außerhalb eines Unterprogramms</translation>
    </message>
    <message>
        <source>Main program repeats</source>
        <translation>Hauptprogramm wiederholt sich</translation>
    </message>
    <message>
        <source>M98 with L0</source>
        <translation>M98 mit L0</translation>
    </message>
    <message>
        <source>Call not first</source>
        <translation>Aufruf nicht am Satzanfang</translation>
    </message>
    <message>
        <source>M99 not alone</source>
        <translation>M99 nicht allein</translation>
    </message>
    <message>
        <source>Too many repeated messages</source>
        <translation>Zu viele wiederholte Meldungen</translation>
    </message>
    <message>
        <source>Too many repeated blocks</source>
        <translation>Zu viele wiederholte Sätze</translation>
    </message>
    <message>
        <source>Loop without motion</source>
        <translation>Schleife ohne Bewegung</translation>
    </message>
    <message>
        <source>Endless loop</source>
        <translation>Endlosschleife</translation>
    </message>
    <message>
        <source>Too many repeats</source>
        <translation>Zu viele Wiederholungen</translation>
    </message>
    <message>
        <source>Too many motions in block</source>
        <translation>Zu viele Bewegungen im Satz</translation>
    </message>
    <message>
        <source>Invalid jump target</source>
        <translation>Ungültiges Sprungziel</translation>
    </message>
    <message>
        <source>Jump target not found</source>
        <translation>Sprungziel nicht gefunden</translation>
    </message>
    <message>
        <source>Duplicate block number</source>
        <translation>Doppelte Satznummer</translation>
    </message>
    <message>
        <source>Incomplete statement</source>
        <translation>Unvollständige Anweisung</translation>
    </message>
    <message>
        <source>Statement not first</source>
        <translation>Anweisung nicht am Satzanfang</translation>
    </message>
    <message>
        <source>Unmatched loop</source>
        <translation>Schleife ohne Gegenstück</translation>
    </message>
    <message>
        <source>Program alarm</source>
        <translation>Programmalarm</translation>
    </message>
    <message>
        <source>Program repeats</source>
        <translation>Programm wiederholt sich</translation>
    </message>
    <message>
        <source>Unsupported encoding</source>
        <translation>Nicht unterstützte Kodierung</translation>
    </message>
    <message>
        <source>Binary file</source>
        <translation>Binärdatei</translation>
    </message>
    <message>
        <source>Invalid M code list</source>
        <translation>Ungültige Liste der M-Befehle</translation>
    </message>
    <message>
        <source>Dialect detected</source>
        <translation>Dialekt erkannt</translation>
    </message>
    <message>
        <source>Unsupported dialect</source>
        <translation>Nicht unterstützter Dialekt</translation>
    </message>
    <message>
        <source>Not an NC program</source>
        <translation>Kein NC-Programm</translation>
    </message>
    <message>
        <source>Text before &quot;%&quot;</source>
        <translation>Text vor „%“</translation>
    </message>
    <message>
        <source>Opening &quot;%&quot; missing</source>
        <translation>„%“ am Anfang fehlt</translation>
    </message>
    <message>
        <source>&quot;%&quot; inside the program</source>
        <translation>„%“ im Programm</translation>
    </message>
    <message>
        <source>Text after &quot;%&quot;</source>
        <translation>Text nach „%“</translation>
    </message>
    <message>
        <source>Blocks after program end</source>
        <translation>Sätze nach dem Programmende</translation>
    </message>
    <message>
        <source>Program end missing</source>
        <translation>Programmende fehlt</translation>
    </message>
    <message>
        <source>No motion</source>
        <translation>Keine Bewegung</translation>
    </message>
    <message>
        <source>Too many motions</source>
        <translation>Zu viele Bewegungen</translation>
    </message>
    <message>
        <source>Program too large</source>
        <translation>Programm zu groß</translation>
    </message>
    <message>
        <source>Too many events</source>
        <translation>Zu viele Ereignisse</translation>
    </message>
    <message>
        <source>Interpretation stopped</source>
        <translation>Interpretation angehalten</translation>
    </message>
    <message>
        <source>Still reading</source>
        <translation>Wird noch gelesen</translation>
    </message>
    <message>
        <source>Unknown code</source>
        <translation>Unbekannter Befehl</translation>
    </message>
    <message>
        <source>Code ignored</source>
        <translation>Befehl ignoriert</translation>
    </message>
    <message>
        <source>Listed code executed</source>
        <translation>Befehl der Liste ausgeführt</translation>
    </message>
    <message>
        <source>Unsupported code</source>
        <translation>Nicht unterstützter Befehl</translation>
    </message>
    <message>
        <source>Conflicting codes</source>
        <translation>Widersprüchliche Befehle</translation>
    </message>
    <message>
        <source>Conflicting codes, last used</source>
        <translation>Widersprüchliche Befehle, letzter gilt</translation>
    </message>
    <message>
        <source>Too many M codes</source>
        <translation>Zu viele M-Befehle</translation>
    </message>
    <message>
        <source>Axis ignored</source>
        <translation>Achse ignoriert</translation>
    </message>
    <message>
        <source>Unused word</source>
        <translation>Unbenutztes Wort</translation>
    </message>
    <message>
        <source>Word ignored</source>
        <translation>Wort ignoriert</translation>
    </message>
    <message>
        <source>No such spindle</source>
        <translation>Spindel nicht vorhanden</translation>
    </message>
    <message>
        <source>No motion code active</source>
        <translation>Kein Bewegungsbefehl aktiv</translation>
    </message>
    <message>
        <source>Axis word with G80</source>
        <translation>Achswort mit G80</translation>
    </message>
    <message>
        <source>Rapid after G80</source>
        <translation>Eilgang nach G80</translation>
    </message>
    <message>
        <source>Word missing</source>
        <translation>Wort fehlt</translation>
    </message>
    <message>
        <source>Negative number</source>
        <translation>Negative Zahl</translation>
    </message>
    <message>
        <source>Not a whole number</source>
        <translation>Keine ganze Zahl</translation>
    </message>
    <message>
        <source>Axis words used twice</source>
        <translation>Achswörter doppelt benutzt</translation>
    </message>
    <message>
        <source>No modal state saved</source>
        <translation>Kein modaler Zustand gesichert</translation>
    </message>
    <message>
        <source>M72 not alone</source>
        <translation>M72 nicht allein</translation>
    </message>
    <message>
        <source>No tool selected</source>
        <translation>Kein Werkzeug gewählt</translation>
    </message>
    <message>
        <source>G43.2 with H and axes</source>
        <translation>G43.2 mit H und Achsen</translation>
    </message>
    <message>
        <source>Unsupported G10</source>
        <translation>Nicht unterstütztes G10</translation>
    </message>
    <message>
        <source>Tool number unknown</source>
        <translation>Werkzeugnummer unbekannt</translation>
    </message>
    <message>
        <source>G53 without G0 or G1</source>
        <translation>G53 ohne G0 oder G1</translation>
    </message>
    <message>
        <source>Polar and Cartesian words</source>
        <translation>Polare und kartesische Wörter</translation>
    </message>
    <message>
        <source>Polar angle undefined</source>
        <translation>Polarwinkel unbestimmt</translation>
    </message>
    <message>
        <source>G53 with polar words</source>
        <translation>G53 mit Polarkoordinaten</translation>
    </message>
    <message>
        <source>G53 in incremental mode</source>
        <translation>G53 bei inkrementaler Maßangabe</translation>
    </message>
    <message>
        <source>G53 ignored</source>
        <translation>G53 ignoriert</translation>
    </message>
    <message>
        <source>Machine zero unknown</source>
        <translation>Maschinennullpunkt unbekannt</translation>
    </message>
    <message>
        <source>Arc outside rotated plane</source>
        <translation>Kreisbogen außerhalb der gedrehten Ebene</translation>
    </message>
    <message>
        <source>Arc scaled unevenly</source>
        <translation>Kreisbogen ungleich skaliert</translation>
    </message>
    <message>
        <source>Scale factor 0</source>
        <translation>Skalierungsfaktor 0</translation>
    </message>
    <message>
        <source>Transformation order</source>
        <translation>Reihenfolge der Transformationen</translation>
    </message>
    <message>
        <source>Transformation centre unknown</source>
        <translation>Zentrum der Transformation unbekannt</translation>
    </message>
    <message>
        <source>Rotation start ambiguous</source>
        <translation>Beginn der Drehung mehrdeutig</translation>
    </message>
    <message>
        <source>Rotation angle ambiguous</source>
        <translation>Drehwinkel mehrdeutig</translation>
    </message>
    <message>
        <source>Reference return in cycle</source>
        <translation>Referenzfahrt im Zyklus</translation>
    </message>
    <message>
        <source>Intermediate point unknown</source>
        <translation>Zwischenpunkt unbekannt</translation>
    </message>
    <message>
        <source>Homing cycle</source>
        <translation>Referenzfahrt</translation>
    </message>
    <message>
        <source>Control data skipped</source>
        <translation>Steuerungsdaten übersprungen</translation>
    </message>
    <message>
        <source>Offset register unknown</source>
        <translation>Korrekturspeicher unbekannt</translation>
    </message>
    <message>
        <source>Length offset without Z</source>
        <translation>Längenkorrektur ohne Z</translation>
    </message>
    <message>
        <source>Rotation with G92 active</source>
        <translation>Drehung bei aktivem G92</translation>
    </message>
    <message>
        <source>Cycle word missing</source>
        <translation>Zykluswort fehlt</translation>
    </message>
    <message>
        <source>Cycle without a position</source>
        <translation>Zyklus ohne Position</translation>
    </message>
    <message>
        <source>Cycle with inverse time</source>
        <translation>Zyklus mit zeitreziprokem Vorschub</translation>
    </message>
    <message>
        <source>R plane below hole bottom</source>
        <translation>R-Ebene unter dem Bohrungsgrund</translation>
    </message>
    <message>
        <source>Invalid peck depth</source>
        <translation>Ungültige Zustelltiefe je Bohrhub</translation>
    </message>
    <message>
        <source>Peck depth missing</source>
        <translation>Zustelltiefe je Bohrhub fehlt</translation>
    </message>
    <message>
        <source>Spindle stopped in cycle</source>
        <translation>Spindel steht im Zyklus</translation>
    </message>
    <message>
        <source>Back boring not verified</source>
        <translation>Rückwärtssenken nicht geprüft</translation>
    </message>
    <message>
        <source>Invalid back boring depth</source>
        <translation>Ungültige Tiefe beim Rückwärtssenken</translation>
    </message>
    <message>
        <source>Back boring with G99</source>
        <translation>Rückwärtssenken mit G99</translation>
    </message>
    <message>
        <source>Tapping feeds off the hole</source>
        <translation>Gewindebohren neben der Bohrung</translation>
    </message>
    <message>
        <source>Fine boring not verified</source>
        <translation>Feinbohren nicht geprüft</translation>
    </message>
    <message>
        <source>Manual retract</source>
        <translation>Rückzug von Hand</translation>
    </message>
    <message>
        <source>Initial level unknown</source>
        <translation>Ausgangsebene unbekannt</translation>
    </message>
    <message>
        <source>Tapping with stopped spindle</source>
        <translation>Gewindebohren bei stehender Spindel</translation>
    </message>
    <message>
        <source>Cycle only stored</source>
        <translation>Zyklus nur gespeichert</translation>
    </message>
    <message>
        <source>Pattern without a cycle</source>
        <translation>Lochbild ohne Zyklus</translation>
    </message>
    <message>
        <source>First hole assumed</source>
        <translation>Erste Bohrung angenommen</translation>
    </message>
    <message>
        <source>Pocket path assumed</source>
        <translation>Taschenbahn angenommen</translation>
    </message>
    <message>
        <source>Invalid pocket size</source>
        <translation>Ungültige Taschengröße</translation>
    </message>
    <message>
        <source>F missing with G93</source>
        <translation>F fehlt bei G93</translation>
    </message>
    <message>
        <source>Feed per revolution without spindle</source>
        <translation>Vorschub je Umdrehung ohne Spindel</translation>
    </message>
    <message>
        <source>Feed before unit change</source>
        <translation>Vorschub vor dem Einheitenwechsel</translation>
    </message>
    <message>
        <source>Diameter mode</source>
        <translation>Durchmesserprogrammierung</translation>
    </message>
    <message>
        <source>Surface speed at limit</source>
        <translation>Schnittgeschwindigkeit an der Grenze</translation>
    </message>
    <message>
        <source>Spindle speed unknown</source>
        <translation>Spindeldrehzahl unbekannt</translation>
    </message>
    <message>
        <source>Invalid pitch</source>
        <translation>Ungültige Steigung</translation>
    </message>
    <message>
        <source>F with synchronised motion</source>
        <translation>F bei synchroner Bewegung</translation>
    </message>
    <message>
        <source>Synchronised motion, spindle stopped</source>
        <translation>Synchrone Bewegung bei stehender Spindel</translation>
    </message>
    <message>
        <source>Feed rate missing</source>
        <translation>Vorschub fehlt</translation>
    </message>
    <message>
        <source>Mist coolant optional</source>
        <translation>Sprühkühlung optional</translation>
    </message>
    <message>
        <source>Dwell unit ambiguous</source>
        <translation>Einheit der Verweilzeit mehrdeutig</translation>
    </message>
    <message>
        <source>Target too far</source>
        <translation>Ziel zu weit entfernt</translation>
    </message>
    <message>
        <source>Start position unknown</source>
        <translation>Startposition unbekannt</translation>
    </message>
    <message>
        <source>Axis never positioned</source>
        <translation>Achse nie positioniert</translation>
    </message>
    <message>
        <source>Incremental from unknown position</source>
        <translation>Inkrementaler Weg ab unbekannter Position</translation>
    </message>
    <message>
        <source>One-sided positioning</source>
        <translation>Einseitiges Positionieren</translation>
    </message>
    <message>
        <source>Arc without centre</source>
        <translation>Kreisbogen ohne Mittelpunkt</translation>
    </message>
    <message>
        <source>Arc centre incomplete</source>
        <translation>Kreismittelpunkt unvollständig</translation>
    </message>
    <message>
        <source>Arc with R and centre</source>
        <translation>Kreisbogen mit R und Mittelpunkt</translation>
    </message>
    <message>
        <source>Arc word outside plane</source>
        <translation>Kreiswort außerhalb der Ebene</translation>
    </message>
    <message>
        <source>Arc radius zero</source>
        <translation>Kreisradius null</translation>
    </message>
    <message>
        <source>Arc end radius mismatch</source>
        <translation>Radius am Kreisende abweichend</translation>
    </message>
    <message>
        <source>Full circle with R</source>
        <translation>Vollkreis mit R</translation>
    </message>
    <message>
        <source>Arc radius too small</source>
        <translation>Kreisradius zu klein</translation>
    </message>
    <message>
        <source>Arc centre ignored</source>
        <translation>Kreismittelpunkt ignoriert</translation>
    </message>
    <message>
        <source>Arc without motion</source>
        <translation>Kreisbogen ohne Bewegung</translation>
    </message>
    <message>
        <source>Arc becomes a line</source>
        <translation>Kreisbogen wird zur Geraden</translation>
    </message>
    <message>
        <source>Arc radius too large</source>
        <translation>Kreisradius zu groß</translation>
    </message>
    <message>
        <source>Arc too long</source>
        <translation>Kreisbogen zu lang</translation>
    </message>
    <message>
        <source>Invalid number of turns</source>
        <translation>Ungültige Zahl der Umläufe</translation>
    </message>
    <message>
        <source>Arc start mismatch</source>
        <translation>Kreisanfang abweichend</translation>
    </message>
    <message>
        <source>Arc word ignored</source>
        <translation>Kreiswort ignoriert</translation>
    </message>
    <message>
        <source>Arc end point missing</source>
        <translation>Kreisendpunkt fehlt</translation>
    </message>
    <message>
        <source>Arc centre ambiguous</source>
        <translation>Kreismittelpunkt mehrdeutig</translation>
    </message>
    <message>
        <source>Polar centre ambiguous</source>
        <translation>Pol mehrdeutig</translation>
    </message>
    <message>
        <source>Polar motion undocumented</source>
        <translation>Polare Bewegung nicht dokumentiert</translation>
    </message>
    <message>
        <source>Radius scaling assumed</source>
        <translation>Radiusskalierung angenommen</translation>
    </message>
    <message>
        <source>XY plane only</source>
        <translation>Nur XY-Ebene</translation>
    </message>
    <message>
        <source>M66 with P and E</source>
        <translation>M66 mit P und E</translation>
    </message>
    <message>
        <source>M66 wait mode</source>
        <translation>Wartemodus von M66</translation>
    </message>
    <message>
        <source>Input value assumed</source>
        <translation>Eingangswert angenommen</translation>
    </message>
    <message>
        <source>Input value used</source>
        <translation>Eingangswert benutzt</translation>
    </message>
    <message>
        <source>Probing with G95</source>
        <translation>Antasten mit G95</translation>
    </message>
    <message>
        <source>Probing motion too short</source>
        <translation>Antastbewegung zu kurz</translation>
    </message>
    <message>
        <source>Skip signal unknown</source>
        <translation>Skip-Signal unbekannt</translation>
    </message>
    <message>
        <source>Probe contact unknown</source>
        <translation>Antastpunkt unbekannt</translation>
    </message>
    <message>
        <source>Probe contact assumed</source>
        <translation>Antastpunkt angenommen</translation>
    </message>
    <message>
        <source>Probe release assumed</source>
        <translation>Freifahrpunkt angenommen</translation>
    </message>
    <message>
        <source>Probe result used</source>
        <translation>Antastergebnis benutzt</translation>
    </message>
    <message>
        <source>Probe without contact</source>
        <translation>Taster ohne Kontakt</translation>
    </message>
    <message>
        <source>Probe still in contact</source>
        <translation>Taster noch in Kontakt</translation>
    </message>
    <message>
        <source>Probe in contact at start</source>
        <translation>Taster beim Start in Kontakt</translation>
    </message>
    <message>
        <source>Probe free at start</source>
        <translation>Taster beim Start frei</translation>
    </message>
    <message>
        <source>Spline outside XY plane</source>
        <translation>Spline außerhalb der XY-Ebene</translation>
    </message>
    <message>
        <source>Spline without I and J</source>
        <translation>Spline ohne I und J</translation>
    </message>
    <message>
        <source>Spline too long</source>
        <translation>Spline zu lang</translation>
    </message>
    <message>
        <source>Control point incomplete</source>
        <translation>Kontrollpunkt unvollständig</translation>
    </message>
    <message>
        <source>Invalid control point weight</source>
        <translation>Ungültiges Gewicht</translation>
    </message>
    <message>
        <source>Weight without control point</source>
        <translation>Gewicht ohne Kontrollpunkt</translation>
    </message>
    <message>
        <source>Too few control points</source>
        <translation>Zu wenige Kontrollpunkte</translation>
    </message>
    <message>
        <source>NURBS block not open</source>
        <translation>NURBS-Block nicht offen</translation>
    </message>
    <message>
        <source>NURBS block not closed</source>
        <translation>NURBS-Block nicht geschlossen</translation>
    </message>
    <message>
        <source>Corner without motions</source>
        <translation>Ecke ohne Bewegungen</translation>
    </message>
    <message>
        <source>Next corner motion missing</source>
        <translation>Folgebewegung der Ecke fehlt</translation>
    </message>
    <message>
        <source>Chamfer and corner radius</source>
        <translation>Fase und Eckenradius</translation>
    </message>
    <message>
        <source>Invalid comma word</source>
        <translation>Ungültiges Kommawort</translation>
    </message>
    <message>
        <source>Corner at compensation change</source>
        <translation>Ecke beim Korrekturwechsel</translation>
    </message>
    <message>
        <source>Negative corner size</source>
        <translation>Negative Eckengröße</translation>
    </message>
    <message>
        <source>Corner scaling assumed</source>
        <translation>Eckenskalierung angenommen</translation>
    </message>
    <message>
        <source>Corner too large</source>
        <translation>Ecke zu groß</translation>
    </message>
    <message>
        <source>Corner outside plane</source>
        <translation>Ecke außerhalb der Ebene</translation>
    </message>
    <message>
        <source>Chamfer on arc</source>
        <translation>Fase am Kreisbogen</translation>
    </message>
    <message>
        <source>Compensation already active</source>
        <translation>Fräserradiuskorrektur bereits aktiv</translation>
    </message>
    <message>
        <source>Compensation plane unsupported</source>
        <translation>Korrekturebene nicht unterstützt</translation>
    </message>
    <message>
        <source>Compensation under rotation</source>
        <translation>Fräserradiuskorrektur bei Drehung</translation>
    </message>
    <message>
        <source>Not allowed with compensation</source>
        <translation>Mit Fräserradiuskorrektur nicht erlaubt</translation>
    </message>
    <message>
        <source>Compensation suspended</source>
        <translation>Fräserradiuskorrektur ausgesetzt</translation>
    </message>
    <message>
        <source>Compensation diameter 0</source>
        <translation>Korrekturdurchmesser 0</translation>
    </message>
    <message>
        <source>Compensation diameter unknown</source>
        <translation>Korrekturdurchmesser unbekannt</translation>
    </message>
    <message>
        <source>Compensation from unknown position</source>
        <translation>Fräserradiuskorrektur ab unbekannter Position</translation>
    </message>
    <message>
        <source>Lead-in too short</source>
        <translation>Anfahrweg zu kurz</translation>
    </message>
    <message>
        <source>Arc smaller than tool</source>
        <translation>Kreisbogen kleiner als das Werkzeug</translation>
    </message>
    <message>
        <source>Inside corner too tight</source>
        <translation>Innenecke zu eng</translation>
    </message>
    <message>
        <source>Compensation gouge</source>
        <translation>Werkstückverletzung durch Korrektur</translation>
    </message>
    <message>
        <source>Compensated motion reversed</source>
        <translation>Korrigierte Bewegung umgekehrt</translation>
    </message>
    <message>
        <source>Stop before inside corner</source>
        <translation>Halt vor der Innenecke</translation>
    </message>
    <message>
        <source>Lead-out on arc</source>
        <translation>Abfahren auf Kreisbogen</translation>
    </message>
    <message>
        <source>Lead-in on arc</source>
        <translation>Anfahren auf Kreisbogen</translation>
    </message>
    <message>
        <source>Corner not compensated</source>
        <translation>Ecke nicht korrigiert</translation>
    </message>
    <message>
        <source>Compensation side change</source>
        <translation>Wechsel der Korrekturseite</translation>
    </message>
    <message>
        <source>Compensation points dropped</source>
        <translation>Korrekturpunkte ausgelassen</translation>
    </message>
    <message>
        <source>Compensated arc off circle</source>
        <translation>Korrigierter Kreisbogen neben dem Kreis</translation>
    </message>
    <message>
        <source>Compensation active at end</source>
        <translation>Fräserradiuskorrektur am Ende aktiv</translation>
    </message>
    <message>
        <source>Code not supported</source>
        <translation>Befehl nicht unterstützt</translation>
    </message>
    <message>
        <source>Word not supported</source>
        <translation>Wort nicht unterstützt</translation>
    </message>
    <message>
        <source>Expressions not supported</source>
        <translation>Ausdrücke nicht unterstützt</translation>
    </message>
    <message>
        <source>Line dropped</source>
        <translation>Zeile übersprungen</translation>
    </message>
    <message>
        <source>Block number too large</source>
        <translation>Satznummer zu groß</translation>
    </message>
    <message>
        <source>System command</source>
        <translation>Systembefehl</translation>
    </message>
    <message>
        <source>Real-time command</source>
        <translation>Echtzeitbefehl</translation>
    </message>
    <message>
        <source>Real-time reset</source>
        <translation>Echtzeit-Reset</translation>
    </message>
    <message>
        <source>Block delete ignored</source>
        <translation>Satzausblendung ignoriert</translation>
    </message>
    <message>
        <source>&quot;%&quot; not supported</source>
        <translation>„%“ nicht unterstützt</translation>
    </message>
    <message>
        <source>Tool not changed</source>
        <translation>Werkzeug nicht gewechselt</translation>
    </message>
    <message>
        <source>Optional stop ignored</source>
        <translation>Wahlweiser Halt ignoriert</translation>
    </message>
    <message>
        <source>Length offset axis</source>
        <translation>Achse der Längenkorrektur</translation>
    </message>
    <message>
        <source>O word not supported</source>
        <translation>O-Wort nicht unterstützt</translation>
    </message>
    <message>
        <source>Length offset number missing</source>
        <translation>Nummer der Längenkorrektur fehlt</translation>
    </message>
    <message>
        <source>Feed rate 0</source>
        <translation>Vorschub 0</translation>
    </message>
    <message>
        <source>Tool length offset missing</source>
        <translation>Werkzeuglängenkorrektur fehlt</translation>
    </message>
    <message>
        <source>Work offset not selected</source>
        <translation>Nullpunktverschiebung nicht gewählt</translation>
    </message>
    <message>
        <source>Length offset mismatch</source>
        <translation>Werkzeuglängenkorrektur passt nicht</translation>
    </message>
    <message>
        <source>D word missing</source>
        <translation>D-Wort fehlt</translation>
    </message>
    <message>
        <source>Compensation start-up on arc</source>
        <translation>Fräserradiuskorrektur beginnt auf Kreisbogen</translation>
    </message>
    <message>
        <source>Mixed units</source>
        <translation>Gemischte Einheiten</translation>
    </message>
    <message>
        <source>Modal function left on</source>
        <translation>Modale Funktion noch aktiv</translation>
    </message>
    <message>
        <source>Tool change too low</source>
        <translation>Werkzeugwechsel zu tief</translation>
    </message>
    <message>
        <source>Tool change, spindle running</source>
        <translation>Werkzeugwechsel bei drehender Spindel</translation>
    </message>
    <message>
        <source>Unreachable block</source>
        <translation>Nicht erreichbarer Satz</translation>
    </message>
    <message>
        <source>Tool not in table</source>
        <translation>Werkzeug nicht in der Tabelle</translation>
    </message>
    <message>
        <source>Nearly a half circle</source>
        <translation>Nahezu ein Halbkreis</translation>
    </message>
    <message>
        <source>File not readable</source>
        <translation>Datei nicht lesbar</translation>
    </message>
    <message>
        <source>File not writable</source>
        <translation>Datei nicht schreibbar</translation>
    </message>
    <message>
        <source>Not a regular file</source>
        <translation>Keine normale Datei</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>More messages</source>
        <translation>Weitere Meldungen</translation>
    </message>
    <message>
        <source>Profile without width</source>
        <translation>Profil ohne Breite</translation>
    </message>
    <message>
        <source>Too many profile points</source>
        <translation>Zu viele Profilpunkte</translation>
    </message>
    <message>
        <source>Profile turns back</source>
        <translation>Profil läuft zurück</translation>
    </message>
    <message>
        <source>Invalid profile point</source>
        <translation>Ungültiger Profilpunkt</translation>
    </message>
    <message>
        <source>Profile falls</source>
        <translation>Profil fällt ab</translation>
    </message>
    <message>
        <source>Profile not at the tip</source>
        <translation>Profil beginnt nicht an der Spitze</translation>
    </message>
    <message>
        <source>Profile arc radius too small</source>
        <translation>Radius des Profilbogens zu klein</translation>
    </message>
    <message>
        <source>Profile arc centre mismatch</source>
        <translation>Mittelpunkt des Profilbogens passt nicht</translation>
    </message>
    <message>
        <source>Profile arc turns back</source>
        <translation>Profilbogen läuft zurück</translation>
    </message>
    <message>
        <source>Profile tip without width</source>
        <translation>Profilspitze ohne Breite</translation>
    </message>
    <message>
        <source>Profile arcs too large</source>
        <translation>Profilbögen zu groß</translation>
    </message>
    <message>
        <source>Tip too large</source>
        <translation>Spitze zu groß</translation>
    </message>
    <message>
        <source>Pilot too large</source>
        <translation>Zapfen zu groß</translation>
    </message>
    <message>
        <source>Pilot too short</source>
        <translation>Zapfen zu kurz</translation>
    </message>
    <message>
        <source>Lead too long</source>
        <translation>Anschnitt zu lang</translation>
    </message>
    <message>
        <source>Corner radius too large</source>
        <translation>Eckenradius zu groß</translation>
    </message>
    <message>
        <source>Taper too low</source>
        <translation>Kegel zu niedrig</translation>
    </message>
    <message>
        <source>Neck too thick</source>
        <translation>Hals zu dick</translation>
    </message>
    <message>
        <source>Head too high</source>
        <translation>Kopf zu hoch</translation>
    </message>
    <message>
        <source>Cutter value not numeric</source>
        <translation>Fräserwert keine Zahl</translation>
    </message>
    <message>
        <source>Cutter value out of range</source>
        <translation>Fräserwert außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>Duplicate cutter key</source>
        <translation>Doppelter Schlüssel (Fräser)</translation>
    </message>
    <message>
        <source>Unknown cutter key</source>
        <translation>Unbekannter Schlüssel (Fräser)</translation>
    </message>
    <message>
        <source>Cutter key missing</source>
        <translation>Schlüssel fehlt (Fräser)</translation>
    </message>
    <message>
        <source>Unknown cutter shape</source>
        <translation>Unbekannte Fräserform</translation>
    </message>
    <message>
        <source>Flute length too short</source>
        <translation>Schneidenlänge zu kurz</translation>
    </message>
    <message>
        <source>Invalid tool number</source>
        <translation>Ungültige Werkzeugnummer</translation>
    </message>
    <message>
        <source>Tool file empty</source>
        <translation>Werkzeugdatei leer</translation>
    </message>
    <message>
        <source>Invalid tool entry</source>
        <translation>Ungültiger Werkzeugeintrag</translation>
    </message>
    <message>
        <source>Duplicate tool</source>
        <translation>Doppeltes Werkzeug</translation>
    </message>
    <message>
        <source>Tool without a cutter</source>
        <translation>Werkzeug ohne Fräser</translation>
    </message>
    <message>
        <source>Invalid tool source</source>
        <translation>Ungültige Werkzeugquelle</translation>
    </message>
    <message>
        <source>Tool file not readable</source>
        <translation>Werkzeugdatei nicht lesbar</translation>
    </message>
    <message>
        <source>Unknown tool key</source>
        <translation>Unbekannter Schlüssel (Werkzeug)</translation>
    </message>
    <message>
        <source>Outline out of range</source>
        <translation>Umriss außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>Outline without area</source>
        <translation>Umriss ohne Fläche</translation>
    </message>
    <message>
        <source>Outline crosses itself</source>
        <translation>Umriss schneidet sich selbst</translation>
    </message>
    <message>
        <source>Invalid grid spacing</source>
        <translation>Ungültige Rasterweite</translation>
    </message>
    <message>
        <source>Invalid stock size</source>
        <translation>Ungültige Rohteilgröße</translation>
    </message>
    <message>
        <source>Stock too narrow</source>
        <translation>Rohteil zu schmal</translation>
    </message>
    <message>
        <source>Invalid stock origin</source>
        <translation>Ungültiger Rohteilursprung</translation>
    </message>
    <message>
        <source>Grid too coarse</source>
        <translation>Raster zu grob</translation>
    </message>
    <message>
        <source>Grid too fine</source>
        <translation>Raster zu fein</translation>
    </message>
    <message>
        <source>Grid lost in rounding</source>
        <translation>Raster geht in Rundung verloren</translation>
    </message>
    <message>
        <source>Not enough memory</source>
        <translation>Zu wenig Speicher</translation>
    </message>
    <message>
        <source>Grid needs too much memory</source>
        <translation>Raster braucht zu viel Speicher</translation>
    </message>
    <message>
        <source>Box without area</source>
        <translation>Bereich ohne Fläche</translation>
    </message>
    <message>
        <source>Box outside the stock</source>
        <translation>Bereich außerhalb des Rohteils</translation>
    </message>
    <message>
        <source>Stock mesh too far</source>
        <translation>Rohteilnetz zu weit entfernt</translation>
    </message>
    <message>
        <source>Stock mesh flat</source>
        <translation>Rohteilnetz ohne Volumen</translation>
    </message>
    <message>
        <source>Too many mesh layers</source>
        <translation>Zu viele Netzschichten</translation>
    </message>
    <message>
        <source>Saved stock empty</source>
        <translation>Gespeichertes Rohteil leer</translation>
    </message>
    <message>
        <source>Invalid stock size text</source>
        <translation>Ungültige Angabe der Rohteilgröße</translation>
    </message>
    <message>
        <source>Stock size not positive</source>
        <translation>Rohteilgröße nicht positiv</translation>
    </message>
    <message>
        <source>Invalid point</source>
        <translation>Ungültiger Punkt</translation>
    </message>
    <message>
        <source>Stock incomplete</source>
        <translation>Rohteil unvollständig</translation>
    </message>
    <message>
        <source>Stock mesh not closed</source>
        <translation>Rohteilnetz nicht geschlossen</translation>
    </message>
    <message>
        <source>Undercut in stock</source>
        <translation>Hinterschnitt im Rohteil</translation>
    </message>
    <message>
        <source>Stock resampled</source>
        <translation>Rohteil umgerechnet</translation>
    </message>
    <message>
        <source>Surface too large</source>
        <translation>Oberfläche zu groß</translation>
    </message>
    <message>
        <source>The surface needs more than the {} of memory that are available, and is drawn without decimation; any surface on a grid of {} mm would fit.</source>
        <translation>Die Oberfläche braucht mehr als die {} Speicher, die verfügbar sind, und wird ohne Dezimierung gezeichnet; auf einem Raster von {} mm würde jede Oberfläche passen.</translation>
    </message>
    <message>
        <source>Choose a coarser grid or a larger allowance.</source>
        <translation>Ein gröberes Raster oder eine größere Toleranz wählen.</translation>
    </message>
    <message>
        <source>The surface needs more than the {} of memory that are available; any surface on a grid of {} mm would fit.</source>
        <translation>Die Oberfläche braucht mehr als die {} Speicher, die verfügbar sind; auf einem Raster von {} mm würde jede Oberfläche passen.</translation>
    </message>
    <message>
        <source>Increase the grid spacing or the allowance, or close other programs.</source>
        <translation>Den Rasterabstand oder die Toleranz vergrößern oder andere Programme schließen.</translation>
    </message>
    <message>
        <source>Map too large for method</source>
        <translation>Z-Map zu groß für das Verfahren</translation>
    </message>
    <message>
        <source>STL file cut off</source>
        <translation>STL-Datei abgeschnitten</translation>
    </message>
    <message>
        <source>STL syntax error</source>
        <translation>STL-Syntaxfehler</translation>
    </message>
    <message>
        <source>Not an STL file</source>
        <translation>Keine STL-Datei</translation>
    </message>
    <message>
        <source>No usable facets</source>
        <translation>Keine brauchbaren Facetten</translation>
    </message>
    <message>
        <source>Data after STL end</source>
        <translation>Daten nach dem STL-Ende</translation>
    </message>
    <message>
        <source>STL end missing</source>
        <translation>STL-Ende fehlt</translation>
    </message>
    <message>
        <source>Facets not finite</source>
        <translation>Facetten nicht endlich</translation>
    </message>
    <message>
        <source>Degenerate facets</source>
        <translation>Entartete Facetten</translation>
    </message>
    <message>
        <source>Normals against winding</source>
        <translation>Normalen gegen den Umlaufsinn</translation>
    </message>
    <message>
        <source>Duplicate facets</source>
        <translation>Doppelte Facetten</translation>
    </message>
    <message>
        <source>Mesh not closed</source>
        <translation>Netz nicht geschlossen</translation>
    </message>
    <message>
        <source>Mesh not manifold</source>
        <translation>Netz nicht mannigfaltig</translation>
    </message>
    <message>
        <source>Flipped facets</source>
        <translation>Umgekehrte Facetten</translation>
    </message>
    <message>
        <source>Mesh inside out</source>
        <translation>Netz umgestülpt</translation>
    </message>
    <message>
        <source>Mesh far from origin</source>
        <translation>Netz weit vom Ursprung</translation>
    </message>
    <message>
        <source>Mesh without size</source>
        <translation>Netz ohne Ausdehnung</translation>
    </message>
    <message>
        <source>Mesh size suspect</source>
        <translation>Netzgröße verdächtig</translation>
    </message>
    <message>
        <source>Not a ZIP archive</source>
        <translation>Kein ZIP-Archiv</translation>
    </message>
    <message>
        <source>Unknown export format</source>
        <translation>Unbekanntes Exportformat</translation>
    </message>
    <message>
        <source>Export rounded too coarsely</source>
        <translation>Export zu grob gerundet</translation>
    </message>
    <message>
        <source>Nothing to export</source>
        <translation>Nichts zu exportieren</translation>
    </message>
    <message>
        <source>Coordinate not finite</source>
        <translation>Koordinate nicht endlich</translation>
    </message>
    <message>
        <source>STL too coarse</source>
        <translation>STL zu grob</translation>
    </message>
    <message>
        <source>Too many triangles</source>
        <translation>Zu viele Dreiecke</translation>
    </message>
    <message>
        <source>Coordinate out of range</source>
        <translation>Koordinate außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>Unsupported NPY type</source>
        <translation>Nicht unterstützter NPY-Typ</translation>
    </message>
    <message>
        <source>Unsupported NPY order</source>
        <translation>Nicht unterstützte NPY-Reihenfolge</translation>
    </message>
    <message>
        <source>Unsupported NPY shape</source>
        <translation>Nicht unterstützte NPY-Form</translation>
    </message>
    <message>
        <source>NPY file cut off</source>
        <translation>NPY-Datei abgeschnitten</translation>
    </message>
    <message>
        <source>Height not finite</source>
        <translation>Höhe nicht endlich</translation>
    </message>
    <message>
        <source>NPY header not readable</source>
        <translation>NPY-Kopf nicht lesbar</translation>
    </message>
    <message>
        <source>Not an NPY file</source>
        <translation>Keine NPY-Datei</translation>
    </message>
    <message>
        <source>Unsupported NPY version</source>
        <translation>Nicht unterstützte NPY-Version</translation>
    </message>
    <message>
        <source>JSON nested too deeply</source>
        <translation>JSON zu tief verschachtelt</translation>
    </message>
    <message>
        <source>Not valid JSON</source>
        <translation>Kein gültiges JSON</translation>
    </message>
    <message>
        <source>Not a Proveout job</source>
        <translation>Kein Proveout-Auftrag</translation>
    </message>
    <message>
        <source>Job of newer version</source>
        <translation>Auftrag einer neueren Version</translation>
    </message>
    <message>
        <source>Program name not UTF-8</source>
        <translation>Programmname nicht UTF-8</translation>
    </message>
    <message>
        <source>File outside job folder</source>
        <translation>Datei außerhalb des Auftragsordners</translation>
    </message>
    <message>
        <source>Unknown job field</source>
        <translation>Unbekanntes Auftragsfeld</translation>
    </message>
    <message>
        <source>Invalid job field</source>
        <translation>Ungültiges Auftragsfeld</translation>
    </message>
    <message>
        <source>Invalid outline point</source>
        <translation>Ungültiger Punkt des Umrisses</translation>
    </message>
    <message>
        <source>Outline loop too short</source>
        <translation>Umriss zu kurz</translation>
    </message>
    <message>
        <source>Outline empty</source>
        <translation>Umriss leer</translation>
    </message>
    <message>
        <source>Unknown stock key</source>
        <translation>Unbekannter Schlüssel (Rohteil)</translation>
    </message>
    <message>
        <source>Invalid stock value</source>
        <translation>Ungültiger Rohteilwert</translation>
    </message>
    <message>
        <source>Invalid stock option</source>
        <translation>Ungültige Rohteiloption</translation>
    </message>
    <message>
        <source>Stock file missing</source>
        <translation>Rohteildatei fehlt</translation>
    </message>
    <message>
        <source>Duplicate stock key</source>
        <translation>Doppelter Schlüssel (Rohteil)</translation>
    </message>
    <message>
        <source>Stock key missing</source>
        <translation>Schlüssel fehlt (Rohteil)</translation>
    </message>
    <message>
        <source>Unknown stock shape</source>
        <translation>Unbekannte Rohteilform</translation>
    </message>
    <message>
        <source>Saved stock damaged</source>
        <translation>Gespeichertes Rohteil beschädigt</translation>
    </message>
    <message>
        <source>Not a saved stock</source>
        <translation>Kein gespeichertes Rohteil</translation>
    </message>
    <message>
        <source>Stock of newer version</source>
        <translation>Rohteil einer neueren Version</translation>
    </message>
    <message>
        <source>Saved grid mismatch</source>
        <translation>Gespeichertes Raster passt nicht</translation>
    </message>
    <message>
        <source>Saved heights invalid</source>
        <translation>Gespeicherte Höhen ungültig</translation>
    </message>
    <message>
        <source>Saved height invalid</source>
        <translation>Gespeicherte Höhe ungültig</translation>
    </message>
    <message>
        <source>Invalid machine value</source>
        <translation>Ungültiger Maschinenwert</translation>
    </message>
    <message>
        <source>Unknown machine key</source>
        <translation>Unbekannter Schlüssel (Maschine)</translation>
    </message>
    <message>
        <source>Parameter out of range</source>
        <translation>Parameter außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>Program never cuts</source>
        <translation>Programm fräst nie</translation>
    </message>
    <message>
        <source>Stock missed</source>
        <translation>Rohteil verfehlt</translation>
    </message>
    <message>
        <source>Grid coarse</source>
        <translation>Raster grob</translation>
    </message>
    <message>
        <source>Rapid cuts stock</source>
        <translation>Eilgang fräst Rohteil</translation>
    </message>
    <message>
        <source>Cut beyond flutes</source>
        <translation>Schnitt tiefer als die Schneiden</translation>
    </message>
    <message>
        <source>Neck in stock</source>
        <translation>Hals im Rohteil</translation>
    </message>
    <message>
        <source>Rapid not checked</source>
        <translation>Eilgang nicht geprüft</translation>
    </message>
    <message>
        <source>Stock above head not shown</source>
        <translation>Rohteil über dem Kopf nicht gezeigt</translation>
    </message>
    <message>
        <source>More findings</source>
        <translation>Weitere Befunde</translation>
    </message>
    <message>
        <source>Tool not confirmed</source>
        <translation>Werkzeug nicht bestätigt</translation>
    </message>
    <message>
        <source>Tool assumed</source>
        <translation>Werkzeug angenommen</translation>
    </message>
    <message>
        <source>Tool not defined</source>
        <translation>Werkzeug nicht definiert</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Kein Werkzeug</translation>
    </message>
    <message>
        <source>Box needs too much memory</source>
        <translation>Bereich braucht zu viel Speicher</translation>
    </message>
    <message>
        <source>Out of memory</source>
        <translation>Speicher erschöpft</translation>
    </message>
    <message>
        <source>Condition too long</source>
        <translation>Bedingung zu lang</translation>
    </message>
    <message>
        <source>Invalid condition</source>
        <translation>Ungültige Bedingung</translation>
    </message>
    <message>
        <source>Study stopped</source>
        <translation>Studie angehalten</translation>
    </message>
    <message>
        <source>Nothing to optimise</source>
        <translation>Nichts zu optimieren</translation>
    </message>
    <message>
        <source>Internal error</source>
        <translation>Interner Fehler</translation>
    </message>
    <message>
        <source>Backup damaged</source>
        <translation>Sicherung beschädigt</translation>
    </message>
    <message>
        <source>File not opened</source>
        <translation>Datei nicht geöffnet</translation>
    </message>
    <message>
        <source>File changed on disk</source>
        <translation>Datei auf dem Datenträger geändert</translation>
    </message>
    <message>
        <source>Stock file changed</source>
        <translation>Rohteildatei geändert</translation>
    </message>
    <message>
        <source>Stock too large</source>
        <translation>Rohteil zu groß</translation>
    </message>
    <message>
        <source>No stock</source>
        <translation>Kein Rohteil</translation>
    </message>
    <message>
        <source>Export in progress</source>
        <translation>Export läuft</translation>
    </message>
    <message>
        <source>Export too large</source>
        <translation>Export zu groß</translation>
    </message>
    <message>
        <source>Export failed</source>
        <translation>Export fehlgeschlagen</translation>
    </message>
    <message>
        <source>Detail region too large</source>
        <translation>Detailbereich zu groß</translation>
    </message>
    <message>
        <source>OpenGL not available</source>
        <translation>OpenGL nicht verfügbar</translation>
    </message>
    <message>
        <source>Export to a format with coordinates in double precision: {4}.</source>
        <translation>Exportieren Sie in ein Format mit Koordinaten in doppelter Genauigkeit: {4}.</translation>
    </message>
    <message>
        <source>Export to a format with coordinates in double precision: {3}.</source>
        <translation>Exportieren Sie in ein Format mit Koordinaten in doppelter Genauigkeit: {3}.</translation>
    </message>
    <message>
        <source>Rounded to single precision, the mesh deviates from the z-map by up to {} mm, more than the error allowance of {} mm; a format in double precision would keep {} mm.</source>
        <translation>Auf einfache Genauigkeit gerundet, liegt die Datei bis zu {} mm neben der Z-Map, mehr als der zulässige Fehler von {} mm; ein Format mit doppelter Genauigkeit bliebe bei {} mm.</translation>
    </message>
    <message>
        <source>Touching parts set apart</source>
        <translation>Berührende Teile getrennt</translation>
    </message>
    <message>
        <source>The mesh deviates from the z-map by up to {} mm, more than the error allowance of {} mm, where parts of the solid that touch at a steep wall are set apart.</source>
        <translation>Das Netz weicht bis zu {} mm von der Z-Map ab, mehr als der zulässige Fehler von {} mm, wo an einer steilen Wand Teile des Körpers getrennt werden, die sich berühren.</translation>
    </message>
    <message>
        <source>Make the stock slightly lower or higher, so that cuts do not end at its floor.</source>
        <translation>Ändern Sie die Höhe des Rohteils etwas, damit Schnitte nicht an seinem Boden enden.</translation>
    </message>
    <message>
        <source>Rounding too large</source>
        <translation>Rundung zu groß</translation>
    </message>
    <message>
        <source>Single precision rounds positions in this stock by up to {} mm, more than half of the error allowance of {} mm; an allowance of at least {} mm or a format in double precision is needed.</source>
        <translation>Einfache Genauigkeit rundet Positionen in diesem Rohteil um bis zu {} mm, mehr als die Hälfte des zulässigen Fehlers von {} mm; nötig ist ein zulässiger Fehler von mindestens {} mm oder ein Format mit doppelter Genauigkeit.</translation>
    </message>
    <message>
        <source>Rounding to single precision changes heights on steep walls by up to {} mm, more than half of the error allowance of {} mm; an allowance of about {} mm or a format in double precision is needed.</source>
        <translation>Das Runden auf einfache Genauigkeit ändert Höhen an steilen Wänden um bis zu {} mm, mehr als die Hälfte des zulässigen Fehlers von {} mm; nötig ist ein zulässiger Fehler von etwa {} mm oder ein Format mit doppelter Genauigkeit.</translation>
    </message>
    <message>
        <source>Export to a format with coordinates in double precision ({4}), or move the stock nearer to the origin.</source>
        <translation>Exportieren Sie in ein Format mit Koordinaten in doppelter Genauigkeit ({4}), oder legen Sie das Rohteil näher an den Nullpunkt.</translation>
    </message>
    <message>
        <source>The coordinates of an STL file are too coarse for this mesh so far from the origin: {} triangles would collapse or turn over, {} vertices meet others; a format in double precision can hold it.</source>
        <translation>Die Koordinaten einer STL-Datei sind für dieses Netz so weit vom Nullpunkt zu grob: {} Dreiecke fielen zusammen oder kehrten sich um, {} Eckpunkte träfen auf andere; ein Format mit doppelter Genauigkeit kann es halten.</translation>
    </message>
    <message>
        <source>Post-process it for one of these dialects: {4}; if it is in one of them after all, choose it.</source>
        <translation>Geben Sie es mit einem Postprozessor für einen dieser Dialekte aus: {4}; ist es doch in einem davon, wählen Sie ihn.</translation>
    </message>
    <message>
        <source>Tool change time</source>
        <translation>Werkzeugwechselzeit</translation>
    </message>
    <message>
        <source>One tenth of the smallest cutter diameter, with 1 to 4 million points</source>
        <translation>Ein Zehntel des kleinsten Fräserdurchmessers, bei 1 bis 4 Millionen Punkten</translation>
    </message>
    <message>
        <source>Dialect of the program</source>
        <translation>Dialekt des Programms</translation>
    </message>
    <message>
        <source>The control that the program is written for; arcs, cycles, offsets and numbers differ from control to control.</source>
        <translation>Die Steuerung, für die das Programm geschrieben ist; Kreisbögen, Zyklen, Korrekturen und Zahlen unterscheiden sich von Steuerung zu Steuerung.</translation>
    </message>
    <message>
        <source>Detected from the program</source>
        <translation>Am Programm erkannt</translation>
    </message>
    <message>
        <source>Block delete (/)</source>
        <translation>Ausblendsätze (/)</translation>
    </message>
    <message>
        <source>Skip blocks that start with /, like the switch on the control.</source>
        <translation>Sätze überspringen, die mit / beginnen, wie mit dem Schalter an der Steuerung.</translation>
    </message>
    <message>
        <source>Type A: straight to the path</source>
        <translation>Typ A: gerade zur Bahn</translation>
    </message>
    <message>
        <source>Type B: round outside corners</source>
        <translation>Typ B: um Außenecken herum</translation>
    </message>
    <message>
        <source>Cutter comp start-up</source>
        <translation>Anfahren der Fräserradiuskorrektur</translation>
    </message>
    <message>
        <source>Start-up and cancel of Fanuc and Haas cutter compensation at outside corners, as set on the control (Fanuc parameter 5003 SUP, Haas setting 43): type A straight, type B round them.</source>
        <translation>An- und Wegfahren der Fräserradiuskorrektur von Fanuc und Haas an Außenecken, wie an der Steuerung eingestellt (Fanuc-Parameter 5003 SUP, Haas-Einstellung 43): Typ A gerade, Typ B um sie herum.</translation>
    </message>
    <message>
        <source>Ignored M codes</source>
        <translation>Ignorierte M-Befehle</translation>
    </message>
    <message>
        <source>M codes that move no axis on this machine: clamps, doors, air, chip conveyor. They are ignored and listed as notes. Results after any other unknown code are unverified.</source>
        <translation>M-Befehle, die an dieser Maschine keine Achse bewegen: Spanner, Türen, Luft, Späneförderer. Sie werden ignoriert und als Hinweise aufgeführt. Ergebnisse nach jedem anderen unbekannten Befehl sind ungeprüft.</translation>
    </message>
    <message>
        <source>Stock shape</source>
        <translation>Form des Rohteils</translation>
    </message>
    <message>
        <source>Invalid holder segment</source>
        <translation>Ungültiger Halterabschnitt</translation>
    </message>
    <message>
        <source>“{}” is not a segment of a holder; a cylinder is written as {}, a cone as {}.</source>
        <translation>„{}“ ist kein Abschnitt eines Halters; ein Zylinder wird als {} geschrieben, ein Kegel als {}.</translation>
    </message>
    <message>
        <source>Holder size out of range</source>
        <translation>Haltermaß außerhalb der Grenzen</translation>
    </message>
    <message>
        <source>The segment {} of the holder has a diameter or height that is out of range, {} to {} mm.</source>
        <translation>Der Abschnitt {} des Halters hat einen Durchmesser oder eine Höhe außerhalb von {} bis {} mm.</translation>
    </message>
    <message>
        <source>Too many holder segments</source>
        <translation>Zu viele Halterabschnitte</translation>
    </message>
    <message>
        <source>The holder has more than {} segments.</source>
        <translation>Der Halter hat mehr als {} Abschnitte.</translation>
    </message>
    <message>
        <source>Holder without stick-out</source>
        <translation>Halter ohne Auskraglänge</translation>
    </message>
    <message>
        <source>A holder needs the key so, the stick-out from the tip to the face of the holder.</source>
        <translation>Ein Halter braucht den Schlüssel so, die Auskraglänge von der Spitze bis zur Stirnfläche des Halters.</translation>
    </message>
    <message>
        <source>Stick-out too short</source>
        <translation>Auskraglänge zu kurz</translation>
    </message>
    <message>
        <source>The stick-out so={} is less than the height of the cutter&apos;s profile, {} mm.</source>
        <translation>Die Auskraglänge so={} ist kleiner als die Höhe des Fräserprofils, {} mm.</translation>
    </message>
    <message>
        <source>Stick-out, from tip to holder (0: unknown)</source>
        <translation>Auskraglänge, von der Spitze bis zum Halter (0: unbekannt)</translation>
    </message>
    <message>
        <source>Holder, DIAMETERxHEIGHT+… from its face upwards</source>
        <translation>Halter, DURCHMESSERxHÖHE+… von der Stirnfläche nach oben</translation>
    </message>
    <message>
        <source>The value of {}, “{}”, is not a whole number.</source>
        <translation>Der Wert von {}, „{}“, ist keine ganze Zahl.</translation>
    </message>
    <message>
        <source>Chip thickness without teeth</source>
        <translation>Spanungsdicke ohne Zähnezahl</translation>
    </message>
    <message>
        <source>A maximum chip thickness, maxchip, needs the key z, the number of teeth of the tool.</source>
        <translation>Eine maximale Spanungsdicke, maxchip, braucht den Schlüssel z, die Zähnezahl des Werkzeugs.</translation>
    </message>
    <message>
        <source>Pitch of the thread (0: unknown)</source>
        <translation>Gewindesteigung (0: unbekannt)</translation>
    </message>
    <message>
        <source>Teeth (0: unknown)</source>
        <translation>Zähne (0: unbekannt)</translation>
    </message>
    <message>
        <source>Centre-cutting (1: yes, 0: no)</source>
        <translation>Über Mitte schneidend (1: ja, 0: nein)</translation>
    </message>
    <message>
        <source>Steepest ramp into material</source>
        <translation>Steilste Rampe ins volle Material</translation>
    </message>
    <message>
        <source>Maximum axial depth (0: any)</source>
        <translation>Maximale axiale Schnitttiefe (0: keine Grenze)</translation>
    </message>
    <message>
        <source>Maximum engagement (0: any)</source>
        <translation>Maximaler radialer Eingriff (0: keine Grenze)</translation>
    </message>
    <message>
        <source>Maximum chip thickness (0: any)</source>
        <translation>Maximale Spanungsdicke (0: keine Grenze)</translation>
    </message>
    <message>
        <source>Maximum spindle speed (0: any)</source>
        <translation>Maximale Spindeldrehzahl (0: keine Grenze)</translation>
    </message>
    <message>
        <source>Maximum feed in a cut (0: any)</source>
        <translation>Maximaler Vorschub im Schnitt (0: keine Grenze)</translation>
    </message>
    <message>
        <source>Maximum surface speed (0: any)</source>
        <translation>Maximale Schnittgeschwindigkeit (0: keine Grenze)</translation>
    </message>
    <message>
        <source>Maximum removal rate (0: any)</source>
        <translation>Maximales Zeitspanvolumen (0: keine Grenze)</translation>
    </message>
    <message>
        <source>Maximum spindle speed</source>
        <translation>Maximale Spindeldrehzahl</translation>
    </message>
    <message>
        <source>Programs are checked for higher spindle speeds; 0: unknown, not checked.</source>
        <translation>Programme werden auf höhere Spindeldrehzahlen geprüft; 0: unbekannt, nicht geprüft.</translation>
    </message>
    <message>
        <source>Motion not allowed for tool</source>
        <translation>Bewegung für Werkzeug nicht erlaubt</translation>
    </message>
    <message>
        <source>The tool plunges {} mm deep into material, but is not centre-cutting.</source>
        <translation>Das Werkzeug taucht {} mm tief ins Material ein, schneidet aber nicht über Mitte.</translation>
    </message>
    <message>
        <source>Drill a hole first, go down on a ramp, or set centre=1 for the tool if it may.</source>
        <translation>Zuerst ein Loch bohren, über eine Rampe eintauchen oder centre=1 für das Werkzeug setzen, wenn es darf.</translation>
    </message>
    <message>
        <source>The plunge goes {} mm deep into material with the unconfirmed tool T{}, which is not centre-cutting.</source>
        <translation>Das Eintauchen geht {} mm tief ins Material, mit dem unbestätigten Werkzeug T{}, das nicht über Mitte schneidet.</translation>
    </message>
    <message>
        <source>Holder collision</source>
        <translation>Halterkollision</translation>
    </message>
    <message>
        <source>The holder collides with the stock, {} mm deep at X{} Y{} Z{}.</source>
        <translation>Der Halter kollidiert mit dem Rohteil, {} mm tief bei X{} Y{} Z{}.</translation>
    </message>
    <message>
        <source>Remove the stock there first, or choose a tool with more stick-out.</source>
        <translation>Das Rohteil dort zuerst abtragen oder ein Werkzeug mit größerer Auskraglänge wählen.</translation>
    </message>
    <message>
        <source>The holder collides with the stock, {} mm deep at X{} Y{} Z{}, with the unconfirmed tool T{}.</source>
        <translation>Der Halter kollidiert mit dem Rohteil, {} mm tief bei X{} Y{} Z{}, mit dem unbestätigten Werkzeug T{}.</translation>
    </message>
    <message>
        <source>Shank collision</source>
        <translation>Schaftkollision</translation>
    </message>
    <message>
        <source>The shank collides with the stock, {} mm deep at X{} Y{} Z{}.</source>
        <translation>Der Schaft kollidiert mit dem Rohteil, {} mm tief bei X{} Y{} Z{}.</translation>
    </message>
    <message>
        <source>Remove the stock there first, or choose a tool with a thinner shank.</source>
        <translation>Das Rohteil dort zuerst abtragen oder ein Werkzeug mit dünnerem Schaft wählen.</translation>
    </message>
    <message>
        <source>The shank collides with the stock, {} mm deep at X{} Y{} Z{}, with the unconfirmed tool T{}.</source>
        <translation>Der Schaft kollidiert mit dem Rohteil, {} mm tief bei X{} Y{} Z{}, mit dem unbestätigten Werkzeug T{}.</translation>
    </message>
    <message>
        <source>Not checked: not enough memory</source>
        <translation>Nicht geprüft: zu wenig Speicher</translation>
    </message>
    <message>
        <source>The program is not checked: that needs {}, but only {} are available.</source>
        <translation>Das Programm ist nicht geprüft: Dafür werden {} gebraucht, verfügbar sind nur {}.</translation>
    </message>
    <message>
        <source>Choose a coarser grid, or close other programs.</source>
        <translation>Wählen Sie ein gröberes Raster, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>There is not enough memory to check the program.</source>
        <translation>Der Speicher reicht nicht aus, um das Programm zu prüfen.</translation>
    </message>
    <message>
        <source>The check failed: {}.</source>
        <translation>Die Prüfung ist gescheitert: {}.</translation>
    </message>
    <message>
        <source>Everything that needs a stock</source>
        <translation>Alles, wofür ein Rohteil nötig ist</translation>
    </message>
    <message>
        <source>Collisions of the tool holder</source>
        <translation>Kollisionen des Halters</translation>
    </message>
    <message>
        <source>Collisions of the shank</source>
        <translation>Kollisionen des Schafts</translation>
    </message>
    <message>
        <source>Collisions with fixtures</source>
        <translation>Kollisionen mit Spannmitteln</translation>
    </message>
    <message>
        <source>Travel limits of the machine</source>
        <translation>Verfahrgrenzen der Maschine</translation>
    </message>
    <message>
        <source>Load of the tools</source>
        <translation>Belastung der Werkzeuge</translation>
    </message>
    <message>
        <source>Undercuts</source>
        <translation>Hinterschnitte</translation>
    </message>
    <message>
        <source>Moves that depend on probing</source>
        <translation>Bewegungen, die vom Antasten abhängen</translation>
    </message>
    <message>
        <source>What the operator does at a program stop</source>
        <translation>Was der Bediener bei einem Programmhalt tut</translation>
    </message>
    <message>
        <source>Spindle stopped</source>
        <translation>Spindel steht</translation>
    </message>
    <message>
        <source>The cutter cuts {} mm deep while the spindle is stopped.</source>
        <translation>Der Fräser fräst {} mm tief, während die Spindel steht.</translation>
    </message>
    <message>
        <source>Program M3 with a speed S before the cut.</source>
        <translation>M3 mit einer Drehzahl S vor dem Schnitt programmieren.</translation>
    </message>
    <message>
        <source>Spindle reversed</source>
        <translation>Spindel dreht rückwärts</translation>
    </message>
    <message>
        <source>The cutter cuts {} mm deep while the spindle turns counterclockwise (M4).</source>
        <translation>Der Fräser fräst {} mm tief, während die Spindel gegen den Uhrzeigersinn dreht (M4).</translation>
    </message>
    <message>
        <source>Program M3, or use a left-hand tool and turn this rule off.</source>
        <translation>M3 programmieren, oder ein linksdrehendes Werkzeug verwenden und diese Regel ausschalten.</translation>
    </message>
    <message>
        <source>Feed rate too high</source>
        <translation>Vorschub zu hoch</translation>
    </message>
    <message>
        <source>The feed rate of {} mm/min is above the maximum of the machine, {} mm/min.</source>
        <translation>Der Vorschub von {} mm/min liegt über dem Höchstwert der Maschine, {} mm/min.</translation>
    </message>
    <message>
        <source>Reduce F, or correct the machine values.</source>
        <translation>F verringern oder die Maschinenwerte berichtigen.</translation>
    </message>
    <message>
        <source>The tool moves sideways in material, {} mm deep, but only cuts along its axis.</source>
        <translation>Das Werkzeug bewegt sich seitwärts im Material, {} mm tief, schneidet aber nur in Achsrichtung.</translation>
    </message>
    <message>
        <source>Retract above the hole before moving in X or Y, or choose a milling cutter.</source>
        <translation>Vor Bewegungen in X oder Y über die Bohrung zurückziehen, oder einen Fräser wählen.</translation>
    </message>
    <message>
        <source>Nothing cut</source>
        <translation>Kein Abtrag</translation>
    </message>
    <message>
        <source>The program does not touch the stock.</source>
        <translation>Das Programm berührt das Rohteil nicht.</translation>
    </message>
    <message>
        <source>Check the position and the size of the stock, the work offset and the tools.</source>
        <translation>Lage und Größe des Rohteils, Nullpunktverschiebung und Werkzeuge prüfen.</translation>
    </message>
    <message>
        <source>The program removes only {} % of the stock, less than {} %.</source>
        <translation>Das Programm trägt nur {} % des Rohteils ab, weniger als {} %.</translation>
    </message>
    <message>
        <source>Wrong unit suspected</source>
        <translation>Vermutlich falsche Maßeinheit</translation>
    </message>
    <message>
        <source>The cuts extend over {} times the size of the stock, about as many as an inch has millimetres.</source>
        <translation>Die Schnitte erstrecken sich über das {}-Fache des Rohteils, etwa so viel, wie ein Zoll Millimeter hat.</translation>
    </message>
    <message>
        <source>Check G20 and G21, and the unit of the stock.</source>
        <translation>G20 und G21 sowie die Maßeinheit des Rohteils prüfen.</translation>
    </message>
    <message>
        <source>The stock is {} times the size of the cuts, about as many as an inch has millimetres.</source>
        <translation>Das Rohteil ist {}-mal so groß wie die Schnitte, etwa so viel, wie ein Zoll Millimeter hat.</translation>
    </message>
    <message>
        <source>Cutter below stock</source>
        <translation>Fräser unter dem Rohteil</translation>
    </message>
    <message>
        <source>The cutter goes {} mm below the bottom of the stock; {} mm are allowed.</source>
        <translation>Der Fräser fährt {} mm unter die Unterseite des Rohteils; erlaubt sind {} mm.</translation>
    </message>
    <message>
        <source>Raise the cut, place the stock higher, or allow more if there is room below.</source>
        <translation>Den Schnitt anheben, das Rohteil höher setzen oder mehr erlauben, wenn darunter Platz ist.</translation>
    </message>
    <message>
        <source>Piece comes loose</source>
        <translation>Teil löst sich</translation>
    </message>
    <message>
        <source>A piece of {} mm³ has come loose from the rest of the stock.</source>
        <translation>Ein Teil von {} mm³ hat sich vom übrigen Rohteil gelöst.</translation>
    </message>
    <message>
        <source>Leave tabs, or turn this rule off if the piece is held.</source>
        <translation>Stege stehen lassen, oder diese Regel ausschalten, wenn das Teil gehalten wird.</translation>
    </message>
    <message>
        <source>Feeding in air</source>
        <translation>Vorschub in der Luft</translation>
    </message>
    <message>
        <source>The cutter moves through air at feed for {} s; up to {} s are not reported.</source>
        <translation>Der Fräser fährt {} s lang im Vorschub durch die Luft; bis {} s werden nicht gemeldet.</translation>
    </message>
    <message>
        <source>Approach with G0 where it is safe.</source>
        <translation>Wo es sicher ist, mit G0 anfahren.</translation>
    </message>
    <message>
        <source>Size and position of the stock, which is fitted to the toolpath</source>
        <translation>Größe und Lage des Rohteils, das an die Werkzeugbahn angepasst ist</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must not be empty.</source>
        <translation>Das Feld &quot;{}&quot; darf nicht leer sein.</translation>
    </message>
    <message>
        <source>Least removal</source>
        <translation>Mindestabtrag</translation>
    </message>
    <message>
        <source>A program that removes less of the stock counts as not cutting.</source>
        <translation>Ein Programm, das weniger vom Rohteil abträgt, gilt als ohne Schnitt.</translation>
    </message>
    <message>
        <source>Room below stock</source>
        <translation>Raum unter dem Rohteil</translation>
    </message>
    <message>
        <source>How far below the bottom of the stock a cutter may go.</source>
        <translation>Wie weit ein Fräser unter die Unterseite des Rohteils gehen darf.</translation>
    </message>
    <message>
        <source>Longer stretches of feeding in air are reported.</source>
        <translation>Längere Strecken mit Vorschub in der Luft werden gemeldet.</translation>
    </message>
    <message>
        <source>Smallest loose piece</source>
        <translation>Kleinstes loses Stück</translation>
    </message>
    <message>
        <source>Smaller pieces that come loose count as chips.</source>
        <translation>Kleinere Stücke, die sich lösen, gelten als Späne.</translation>
    </message>
    <message>
        <source>Clearance of fixtures</source>
        <translation>Abstand zu Spannmitteln</translation>
    </message>
    <message>
        <source>A tool that comes nearer to a fixture is reported, across and upwards.</source>
        <translation>Ein Werkzeug, das einem Spannmittel näher kommt, wird gemeldet, seitlich und nach oben.</translation>
    </message>
    <message>
        <source>Feed of taps</source>
        <translation>Vorschub von Gewindebohrern</translation>
    </message>
    <message>
        <source>How far the feed of a tap may be from its pitch.</source>
        <translation>Wie weit der Vorschub eines Gewindebohrers von seiner Steigung abweichen darf.</translation>
    </message>
    <message>
        <source>Clearance of rapids</source>
        <translation>Abstand von Eilgängen</translation>
    </message>
    <message>
        <source>Rapids that pass less than this above the stock are reported; 0: none.</source>
        <translation>Eilgänge, die näher über dem Rohteil verlaufen, werden gemeldet; 0: keine.</translation>
    </message>
    <message>
        <source>Travel X from</source>
        <translation>Verfahrweg X von</translation>
    </message>
    <message>
        <source>Least machine coordinate of X; the same as the greatest: unknown, not checked.</source>
        <translation>Kleinste Maschinenkoordinate von X; gleich der größten: unbekannt, nicht geprüft.</translation>
    </message>
    <message>
        <source>Travel X to</source>
        <translation>Verfahrweg X bis</translation>
    </message>
    <message>
        <source>Greatest machine coordinate of X.</source>
        <translation>Größte Maschinenkoordinate von X.</translation>
    </message>
    <message>
        <source>Travel Y from</source>
        <translation>Verfahrweg Y von</translation>
    </message>
    <message>
        <source>Least machine coordinate of Y; the same as the greatest: unknown, not checked.</source>
        <translation>Kleinste Maschinenkoordinate von Y; gleich der größten: unbekannt, nicht geprüft.</translation>
    </message>
    <message>
        <source>Travel Y to</source>
        <translation>Verfahrweg Y bis</translation>
    </message>
    <message>
        <source>Greatest machine coordinate of Y.</source>
        <translation>Größte Maschinenkoordinate von Y.</translation>
    </message>
    <message>
        <source>Travel Z from</source>
        <translation>Verfahrweg Z von</translation>
    </message>
    <message>
        <source>Least machine coordinate of Z; the same as the greatest: unknown, not checked.</source>
        <translation>Kleinste Maschinenkoordinate von Z; gleich der größten: unbekannt, nicht geprüft.</translation>
    </message>
    <message>
        <source>Travel Z to</source>
        <translation>Verfahrweg Z bis</translation>
    </message>
    <message>
        <source>Greatest machine coordinate of Z.</source>
        <translation>Größte Maschinenkoordinate von Z.</translation>
    </message>
    <message>
        <source>Part zero X</source>
        <translation>Nullpunkt X</translation>
    </message>
    <message>
        <source>Machine coordinate X of X0 in the program, as in G54 of the control; all three 0: unknown.</source>
        <translation>Maschinenkoordinate X von X0 im Programm, wie in G54 der Steuerung; alle drei 0: unbekannt.</translation>
    </message>
    <message>
        <source>Part zero Y</source>
        <translation>Nullpunkt Y</translation>
    </message>
    <message>
        <source>Machine coordinate Y of Y0 in the program, as in G54 of the control.</source>
        <translation>Maschinenkoordinate Y von Y0 im Programm, wie in G54 der Steuerung.</translation>
    </message>
    <message>
        <source>Part zero Z</source>
        <translation>Nullpunkt Z</translation>
    </message>
    <message>
        <source>Machine coordinate Z with the face of the spindle at Z0 of the program.</source>
        <translation>Maschinenkoordinate Z, wenn die Spindelnase auf Z0 des Programms steht.</translation>
    </message>
    <message>
        <source>Router 600 × 400 × 100</source>
        <translation>Portalfräse 600 × 400 × 100</translation>
    </message>
    <message>
        <source>Knee mill 760 × 400 × 125</source>
        <translation>Konsolfräsmaschine 760 × 400 × 125</translation>
    </message>
    <message>
        <source>Machining centre 500 × 400 × 500</source>
        <translation>Bearbeitungszentrum 500 × 400 × 500</translation>
    </message>
    <message>
        <source>Machining centre 760 × 400 × 500</source>
        <translation>Bearbeitungszentrum 760 × 400 × 500</translation>
    </message>
    <message>
        <source>Machining centre 1270 × 660 × 635</source>
        <translation>Bearbeitungszentrum 1270 × 660 × 635</translation>
    </message>
    <message>
        <source>Unknown machine profile</source>
        <translation>Unbekanntes Maschinenprofil</translation>
    </message>
    <message>
        <source>The machine profile &quot;{}&quot; is unknown; the profiles are {}.</source>
        <translation>Das Maschinenprofil &quot;{}&quot; ist unbekannt; die Profile sind {}.</translation>
    </message>
    <message>
        <source>Begin with a profile, or write values only, as in rapidXY=20000.</source>
        <translation>Beginnen Sie mit einem Profil oder schreiben Sie nur Werte, wie in rapidXY=20000.</translation>
    </message>
    <message>
        <source>Waiver without its finding</source>
        <translation>Freigabe ohne ihren Befund</translation>
    </message>
    <message>
        <source>The waiver of {} by {} ({}) has no effect: that finding is gone or has changed.</source>
        <translation>Die Freigabe von {} durch {} ({}) ist wirkungslos: Der Befund ist verschwunden oder hat sich geändert.</translation>
    </message>
    <message>
        <source>Remove the waiver, or look at the finding and waive it again.</source>
        <translation>Entfernen Sie die Freigabe, oder sehen Sie den Befund noch einmal an und geben Sie ihn neu frei.</translation>
    </message>
    <message>
        <source>Waived</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>This does not count in the verdict: waived by {} ({}).</source>
        <translation>Das zählt nicht für das Urteil: freigegeben durch {} ({}).</translation>
    </message>
    <message>
        <source>Unknown rule in the job</source>
        <translation>Unbekannte Regel im Auftrag</translation>
    </message>
    <message>
        <source>The job names “{}”, but nothing that is checked has this id.</source>
        <translation>Der Auftrag nennt „{}“, doch nichts, was geprüft wird, hat diese Kennung.</translation>
    </message>
    <message>
        <source>Correct the id; “proveout-cli rules” lists all of them.</source>
        <translation>Berichtigen Sie die Kennung; „proveout-cli rules“ führt alle auf.</translation>
    </message>
    <message>
        <source>Beyond the travel</source>
        <translation>Über den Verfahrweg hinaus</translation>
    </message>
    <message>
        <source>{3} moves {1} mm beyond its travel limit, {2} mm in machine coordinates.</source>
        <translation>{3} fährt {1} mm über seine Verfahrgrenze hinaus, {2} mm in Maschinenkoordinaten.</translation>
    </message>
    <message>
        <source>Place the part elsewhere, turn it, or shorten the motion.</source>
        <translation>Spannen Sie das Teil anderswo oder gedreht auf, oder kürzen Sie die Bewegung.</translation>
    </message>
    <message>
        <source>Travel of Z with tools without a holder</source>
        <translation>Verfahrweg von Z mit Werkzeugen ohne Halter</translation>
    </message>
    <message>
        <source>Jaw width</source>
        <translation>Backenbreite</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>Jaw height</source>
        <translation>Backenhöhe</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Nut diameter</source>
        <translation>⌀ Mutter</translation>
    </message>
    <message>
        <source>{}: unknown ({})</source>
        <translation>{}: unbekannt ({})</translation>
    </message>
    <message>
        <source>{}: {} ({})</source>
        <translation>{}: {} ({})</translation>
    </message>
    <message>
        <source>Modal group: {}</source>
        <translation>Modale Gruppe: {}</translation>
    </message>
    <message>
        <source>Not supported: results after this block are unverified</source>
        <translation>Nicht unterstützt: Ergebnisse nach diesem Satz sind ungeprüft</translation>
    </message>
    <message>
        <source>Least X</source>
        <translation>Min. X</translation>
    </message>
    <message>
        <source>Least Y</source>
        <translation>Min. Y</translation>
    </message>
    <message>
        <source>Bottom Z</source>
        <translation>Unterkante Z</translation>
    </message>
    <message>
        <source>Width (X)</source>
        <translation>Breite X</translation>
    </message>
    <message>
        <source>Depth (Y)</source>
        <translation>Länge Y</translation>
    </message>
    <message>
        <source>Axis X</source>
        <translation>Achse X</translation>
    </message>
    <message>
        <source>Axis Y</source>
        <translation>Achse Y</translation>
    </message>
    <message>
        <source>The waiver of {1} by {2} ({3}) has no effect: T{4} is now “{5}”, it was “{6}”.</source>
        <translation>Die Freigabe von {1} durch {2} ({3}) ist wirkungslos: T{4} ist jetzt „{5}“, war aber „{6}“.</translation>
    </message>
    <message>
        <source>About its Z axis, counter-clockwise from above.</source>
        <translation>Um die eigene Z-Achse, von oben gesehen gegen den Uhrzeigersinn.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Millimetres in a unit of the file: 1, or 25.4 for inches.</source>
        <translation>Millimeter je Einheit der Datei: 1, oder 25,4 für Zoll.</translation>
    </message>
    <message>
        <source>Zero X</source>
        <translation>Nullpunkt X</translation>
    </message>
    <message>
        <source>Zero Y</source>
        <translation>Nullpunkt Y</translation>
    </message>
    <message>
        <source>Zero Z</source>
        <translation>Nullpunkt Z</translation>
    </message>
    <message>
        <source>A fixture cannot have the shape &quot;{}&quot;; it can be a box, a cylinder or a mesh (stl).</source>
        <translation>Ein Spannmittel kann nicht die Form „{}“ haben, nur Quader (box), Zylinder (cylinder) oder Netz (stl).</translation>
    </message>
    <message>
        <source>Fixture without a file</source>
        <translation>Spannmittel ohne Datei</translation>
    </message>
    <message>
        <source>A fixture of the shape &quot;stl&quot; needs the name of its file, as in stl:file=vice.stl.</source>
        <translation>Ein Spannmittel der Form „stl“ braucht den Namen seiner Datei, z. B. stl:file=vice.stl.</translation>
    </message>
    <message>
        <source>Fixture not checked</source>
        <translation>Spannmittel nicht geprüft</translation>
    </message>
    <message>
        <source>The fixture &quot;{}&quot; is not checked, because its file cannot be used: {}</source>
        <translation>Das Spannmittel „{}“ wird nicht geprüft, weil seine Datei nicht verwendbar ist: {}</translation>
    </message>
    <message>
        <source>Correct the file, or choose another one.</source>
        <translation>Korrigieren Sie die Datei, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>The file of the fixture has not been read.</source>
        <translation>Die Datei des Spannmittels wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>The mesh has {} facets; a fixture can have {}.</source>
        <translation>Das Netz hat {} Facetten; ein Spannmittel kann {} haben.</translation>
    </message>
    <message>
        <source>Simplify the mesh.</source>
        <translation>Vereinfachen Sie das Netz.</translation>
    </message>
    <message>
        <source>The file has {}; that of a fixture can have {}.</source>
        <translation>Die Datei hat {}; die eines Spannmittels kann {} haben.</translation>
    </message>
    <message>
        <source>The mesh has a coordinate beyond {} mm.</source>
        <translation>Das Netz hat eine Koordinate jenseits von {} mm.</translation>
    </message>
    <message>
        <source>Fixture with holes</source>
        <translation>Spannmittel mit Löchern</translation>
    </message>
    <message>
        <source>The fixture &quot;{}&quot; is not checked where its mesh has holes: {}</source>
        <translation>Das Spannmittel „{}“ wird dort nicht geprüft, wo sein Netz Löcher hat: {}</translation>
    </message>
    <message>
        <source>Export it again as one closed solid.</source>
        <translation>Exportieren Sie es noch einmal als einen geschlossenen Körper.</translation>
    </message>
    <message>
        <source>Clearance of holders</source>
        <translation>Abstand der Halter</translation>
    </message>
    <message>
        <source>A shank or holder that comes nearer to the stock is reported; 0: none.</source>
        <translation>Schaft oder Halter, die dem Rohteil näher kommen, werden gemeldet; 0: keine.</translation>
    </message>
    <message>
        <source>Tool change X</source>
        <translation>Werkzeugwechsel X</translation>
    </message>
    <message>
        <source>Machine coordinate X that M6 needs; -1000000: any. Leave it if M6 itself moves there.</source>
        <translation>Maschinenkoordinate X, die M6 verlangt; -1000000: beliebig. Nicht angeben, wenn M6 selbst dorthin fährt.</translation>
    </message>
    <message>
        <source>Tool change Y</source>
        <translation>Werkzeugwechsel Y</translation>
    </message>
    <message>
        <source>The same for Y.</source>
        <translation>Dasselbe für Y.</translation>
    </message>
    <message>
        <source>Tool change Z</source>
        <translation>Werkzeugwechsel Z</translation>
    </message>
    <message>
        <source>The same for Z, with the face of the spindle there.</source>
        <translation>Dasselbe für Z, mit der Spindelnase dort.</translation>
    </message>
    <message>
        <source>Tool change elsewhere</source>
        <translation>Werkzeugwechsel am falschen Ort</translation>
    </message>
    <message>
        <source>{3} is {1} mm away from the tool change position, {2} mm in machine coordinates, when the tool is changed.</source>
        <translation>{3} ist beim Werkzeugwechsel {1} mm von der Wechselposition entfernt, die in Maschinenkoordinaten bei {2} mm liegt.</translation>
    </message>
    <message>
        <source>Move there before M6, for example with G28 or G53.</source>
        <translation>Fahren Sie vor M6 dorthin, zum Beispiel mit G28 oder G53.</translation>
    </message>
    <message>
        <source>Holder close to stock</source>
        <translation>Halter nahe am Rohteil</translation>
    </message>
    <message>
        <source>The holder passes nearer than {2} mm to the stock, by {1} mm. To the sides, up to {3} mm of this may be due to the grid.</source>
        <translation>Der Halter kommt dem Rohteil näher als {2} mm, um {1} mm. Seitlich können bis zu {3} mm davon am Gitter liegen.</translation>
    </message>
    <message>
        <source>Extend the tool, choose a slimmer holder or a finer grid, or reduce holderClearance.</source>
        <translation>Spannen Sie das Werkzeug länger, wählen Sie einen schlankeren Halter oder ein feineres Gitter, oder verkleinern Sie holderClearance.</translation>
    </message>
    <message>
        <source>Shank close to stock</source>
        <translation>Schaft nahe am Rohteil</translation>
    </message>
    <message>
        <source>The shank passes nearer than {2} mm to the stock, by {1} mm. To the sides, up to {3} mm of this may be due to the grid.</source>
        <translation>Der Schaft kommt dem Rohteil näher als {2} mm, um {1} mm. Seitlich können bis zu {3} mm davon am Gitter liegen.</translation>
    </message>
    <message>
        <source>Choose a tool with longer flutes or a finer grid, or reduce holderClearance.</source>
        <translation>Wählen Sie ein Werkzeug mit längeren Schneiden oder ein feineres Gitter, oder verkleinern Sie holderClearance.</translation>
    </message>
    <message>
        <source>Walls at grid points</source>
        <translation>Wände an Gitterpunkten</translation>
    </message>
    <message>
        <source>Use a finer grid for walls that are close together.</source>
        <translation>Für Wände, die nahe beieinander stehen, ein feineres Gitter verwenden.</translation>
    </message>
    <message>
        <source>{} of {} points beside walls are at points of the grid in the file: the grid does not resolve the walls around them.</source>
        <translation>{} von {} Punkten an Wänden liegen in der Datei auf Punkten des Rasters: das Raster löst die Wände um sie nicht auf.</translation>
    </message>
    <message>
        <source>Ribs between grid points</source>
        <translation>Stege zwischen Gitterpunkten</translation>
    </message>
    <message>
        <source>Ribs thinner than the grid spacing are missing from the file: {} places between grid points, the first at X{} Y{}.</source>
        <translation>In der Datei fehlen Stege, die dünner sind als die Rasterweite: Sie stehen an {} Stellen zwischen den Gitterpunkten, zuerst bei X{} Y{}.</translation>
    </message>
    <message>
        <source>Use a finer grid, or look at these places in a detail region.</source>
        <translation>Ein feineres Gitter verwenden oder diese Stellen in einem Detailbereich ansehen.</translation>
    </message>
    <message>
        <source>GLB file too large</source>
        <translation>GLB-Datei zu groß</translation>
    </message>
    <message>
        <source>The mesh of {} triangles needs more than {} bytes, the most that a GLB file holds.</source>
        <translation>Das Netz mit {} Dreiecken braucht mehr als {} Bytes; mehr fasst eine GLB-Datei nicht.</translation>
    </message>
    <message>
        <source>Export with a larger error allowance, or to another format.</source>
        <translation>Mit größerem zulässigen Fehler oder in ein anderes Format exportieren.</translation>
    </message>
    <message>
        <source>The vertex {}, {}, {} is out of the range of single precision.</source>
        <translation>Der Eckpunkt {}, {}, {} liegt außerhalb des Bereichs einfacher Genauigkeit.</translation>
    </message>
    <message>
        <source>GLB (glTF 2.0)</source>
        <translation>GLB (glTF 2.0)</translation>
    </message>
    <message>
        <source>Some walls in the file are at points of the grid: in {} of {} squares of 64 × 64 points, more than {} motions of the program are near the walls, or the walls of the stock are unknown.</source>
        <translation>Einige Wände in der Datei liegen auf Punkten des Rasters: in {} von {} Quadraten aus 64 × 64 Punkten sind mehr als {} Bewegungen des Programms nahe an den Wänden, oder die Wände des Rohteils sind unbekannt.</translation>
    </message>
    <message>
        <source>Use a finer grid, so that fewer motions are over each square, or a stock whose walls are known.</source>
        <translation>Ein feineres Gitter verwenden, sodass weniger Bewegungen über jedem Quadrat liegen, oder ein Rohteil, dessen Wände bekannt sind.</translation>
    </message>
    <message>
        <source>Stock walls at grid points</source>
        <translation>Rohteilwände auf Rasterpunkten</translation>
    </message>
    <message>
        <source>The walls of the saved stock are at grid points: they are known on its own grid, with a spacing of {} × {} mm, and with its own height only.</source>
        <translation>Die Wände des gespeicherten Rohteils liegen auf Rasterpunkten: sie sind nur auf seinem eigenen Raster mit einem Abstand von {} × {} mm und mit seiner eigenen Höhe bekannt.</translation>
    </message>
    <message>
        <source>Use the spacing and the height of the saved stock to keep its walls.</source>
        <translation>Den Abstand und die Höhe des gespeicherten Rohteils verwenden, um seine Wände zu behalten.</translation>
    </message>
    <message>
        <source>The walls of the stock mesh are at grid points: more than {} of its triangles, on average, are over one place, too many to find walls between the points.</source>
        <translation>Die Wände des Rohteilnetzes liegen auf Rasterpunkten: im Mittel liegen mehr als {} seiner Dreiecke über einer Stelle, zu viele, um Wände zwischen den Punkten zu finden.</translation>
    </message>
    <message>
        <source>Export the stock with triangles that are less long and narrow.</source>
        <translation>Das Rohteil mit weniger langen und schmalen Dreiecken exportieren.</translation>
    </message>
    <message>
        <source>Unknown key of part</source>
        <translation>Unbekannter Wert des Fertigteils</translation>
    </message>
    <message>
        <source>The design part has no &quot;{}&quot;; it has {}.</source>
        <translation>Das Fertigteil hat kein „{}“; es hat {}.</translation>
    </message>
    <message>
        <source>Invalid value of part</source>
        <translation>Ungültiger Wert des Fertigteils</translation>
    </message>
    <message>
        <source>&quot;{}&quot; of the design part must be a number from {} to {}.</source>
        <translation>„{}“ des Fertigteils muss eine Zahl von {} bis {} sein.</translation>
    </message>
    <message>
        <source>Part without a file</source>
        <translation>Fertigteil ohne Datei</translation>
    </message>
    <message>
        <source>The design part needs the name of its file, as in x=0,y=0,z=0,file=part.stl.</source>
        <translation>Das Fertigteil braucht den Namen seiner Datei, wie in x=0,y=0,z=0,file=part.stl.</translation>
    </message>
    <message>
        <source>Part not compared</source>
        <translation>Fertigteil nicht verglichen</translation>
    </message>
    <message>
        <source>The stock is not compared with the part, because its file cannot be used: {}</source>
        <translation>Das Rohteil wird nicht mit dem Fertigteil verglichen, weil dessen Datei nicht verwendet werden kann: {}</translation>
    </message>
    <message>
        <source>The program is checked without a stock, so there is nothing to compare with the part.</source>
        <translation>Das Programm wird ohne Rohteil geprüft; mit dem Fertigteil kann daher nichts verglichen werden.</translation>
    </message>
    <message>
        <source>State the stock.</source>
        <translation>Geben Sie das Rohteil an.</translation>
    </message>
    <message>
        <source>Format of part unknown</source>
        <translation>Format des Fertigteils unbekannt</translation>
    </message>
    <message>
        <source>A design part cannot be read from a file that ends in &quot;{}&quot;.</source>
        <translation>Ein Fertigteil kann nicht aus einer Datei mit der Endung „{}“ gelesen werden.</translation>
    </message>
    <message>
        <source>Export the part as STL.</source>
        <translation>Exportieren Sie das Teil als STL.</translation>
    </message>
    <message>
        <source>Part too large</source>
        <translation>Fertigteil zu groß</translation>
    </message>
    <message>
        <source>The part needs {}; {} are available.</source>
        <translation>Das Fertigteil braucht {}; verfügbar sind {}.</translation>
    </message>
    <message>
        <source>Export the part with fewer facets.</source>
        <translation>Exportieren Sie das Teil mit weniger Facetten.</translation>
    </message>
    <message>
        <source>Part turned over in places</source>
        <translation>Fertigteil stellenweise umgestülpt</translation>
    </message>
    <message>
        <source>Neighbouring facets of the part face to opposite sides at {} edges, so that inside and outside are not known.</source>
        <translation>An {} Kanten zeigen benachbarte Facetten des Fertigteils zu entgegengesetzten Seiten; innen und außen sind daher nicht bekannt.</translation>
    </message>
    <message>
        <source>Part repaired</source>
        <translation>Fertigteil repariert</translation>
    </message>
    <message>
        <source>The part is inside out; all {} facets were turned over.</source>
        <translation>Das Fertigteil ist umgestülpt; alle {} Facetten wurden umgedreht.</translation>
    </message>
    <message>
        <source>{} facets of the part are there twice; one of each was left out.</source>
        <translation>{} Facetten des Fertigteils sind doppelt vorhanden; je eine wurde weggelassen.</translation>
    </message>
    <message>
        <source>Part not closed</source>
        <translation>Fertigteil nicht geschlossen</translation>
    </message>
    <message>
        <source>The part is not closed at {} edges; places next to them are not judged.</source>
        <translation>Das Fertigteil ist an {} Kanten nicht geschlossen; Stellen daneben werden nicht beurteilt.</translation>
    </message>
    <message>
        <source>Part touches itself</source>
        <translation>Fertigteil berührt sich</translation>
    </message>
    <message>
        <source>At {} edges of the part more than two facets meet.</source>
        <translation>An {} Kanten des Fertigteils treffen sich mehr als zwei Facetten.</translation>
    </message>
    <message>
        <source>Part gouged</source>
        <translation>Werkstück verletzt</translation>
    </message>
    <message>
        <source>The tool cuts {} mm into the part; {} mm are allowed.</source>
        <translation>Das Werkzeug schneidet {} mm in das Fertigteil; erlaubt sind {} mm.</translation>
    </message>
    <message>
        <source>Correct the toolpath, the tool or its length, or allow more.</source>
        <translation>Korrigieren Sie die Werkzeugbahn, das Werkzeug oder seine Länge, oder erlauben Sie mehr.</translation>
    </message>
    <message>
        <source>Stock left on part</source>
        <translation>Restmaterial am Fertigteil</translation>
    </message>
    <message>
        <source>{} mm of stock are left on the part; {} mm are allowed.</source>
        <translation>{} mm Material bleiben am Fertigteil stehen; erlaubt sind {} mm.</translation>
    </message>
    <message>
        <source>Machine what is left, or state the allowance if it is to stay.</source>
        <translation>Bearbeiten Sie, was stehen bleibt, oder geben Sie das Aufmaß an, wenn es bleiben soll.</translation>
    </message>
    <message>
        <source>{} mm of the part are missing where no tool cuts; {} mm are allowed.</source>
        <translation>{} mm des Fertigteils fehlen, wo kein Werkzeug schneidet; erlaubt sind {} mm.</translation>
    </message>
    <message>
        <source>Check the size and the position of the stock and of the part.</source>
        <translation>Prüfen Sie Größe und Lage von Rohteil und Fertigteil.</translation>
    </message>
    <message>
        <source>Part outside of stock</source>
        <translation>Fertigteil außerhalb des Rohteils</translation>
    </message>
    <message>
        <source>The part reaches {} mm beyond the stock ({}); it is not compared there.</source>
        <translation>Das Fertigteil ragt {} mm über das Rohteil hinaus ({}); dort wird es nicht verglichen.</translation>
    </message>
    <message>
        <source>Check the position of the part, its unit, and the stock.</source>
        <translation>Prüfen Sie die Lage des Fertigteils, seine Einheit und das Rohteil.</translation>
    </message>
    <message>
        <source>Part misplaced</source>
        <translation>Fertigteil falsch platziert</translation>
    </message>
    <message>
        <source>Only {} % of the part are within the stock: it is not compared.</source>
        <translation>Nur {} % des Fertigteils liegen im Rohteil: es wird nicht verglichen.</translation>
    </message>
    <message>
        <source>Inside of part unknown</source>
        <translation>Inneres des Fertigteils unbekannt</translation>
    </message>
    <message>
        <source>At {} points the mesh does not tell whether they are inside or outside of the part.</source>
        <translation>An {} Punkten ist aus dem Netz nicht zu erkennen, ob sie innerhalb oder außerhalb des Fertigteils liegen.</translation>
    </message>
    <message>
        <source>Export the part again as one closed solid without overlapping bodies.</source>
        <translation>Exportieren Sie das Teil erneut als einen geschlossenen Körper ohne überlappende Körper.</translation>
    </message>
    <message>
        <source>Walls not resolved</source>
        <translation>Wände nicht aufgelöst</translation>
    </message>
    <message>
        <source>{} mm² of the steep faces of the part cannot be judged at this grid spacing.</source>
        <translation>{} mm² der steilen Flächen des Fertigteils können mit diesem Gitterabstand nicht beurteilt werden.</translation>
    </message>
    <message>
        <source>Choose a finer grid, or a wider tolerance.</source>
        <translation>Wählen Sie ein feineres Gitter oder eine größere Toleranz.</translation>
    </message>
    <message>
        <source>Thin ribs are left at {} places between the points of the grid, and are not compared.</source>
        <translation>An {} Stellen bleiben dünne Stege zwischen den Gitterpunkten stehen; sie werden nicht verglichen.</translation>
    </message>
    <message>
        <source>Choose a finer grid.</source>
        <translation>Wählen Sie ein feineres Gitter.</translation>
    </message>
    <message>
        <source>Undercut of part</source>
        <translation>Hinterschnitt des Fertigteils</translation>
    </message>
    <message>
        <source>{} mm² of the part are below other faces of it, where no tool reaches them along Z; stock is left there.</source>
        <translation>{} mm² des Fertigteils liegen unter anderen Flächen, wo sie kein Werkzeug entlang Z erreicht; dort bleibt Material stehen.</translation>
    </message>
    <message>
        <source>Program coordinate of the zero of the part&apos;s file.</source>
        <translation>Programmkoordinate des Nullpunkts der Datei des Fertigteils.</translation>
    </message>
    <message>
        <source>May be missing</source>
        <translation>Darf fehlen</translation>
    </message>
    <message>
        <source>Tolerance into the part, normal to its surface; more is a gouge.</source>
        <translation>Toleranz in das Fertigteil hinein, senkrecht zur Oberfläche; mehr ist eine Werkstückverletzung.</translation>
    </message>
    <message>
        <source>May be left</source>
        <translation>Darf stehen bleiben</translation>
    </message>
    <message>
        <source>Tolerance outside of the part, normal to its surface; more is excess.</source>
        <translation>Toleranz außerhalb des Fertigteils, senkrecht zur Oberfläche; mehr ist Restmaterial.</translation>
    </message>
    <message>
        <source>Stock allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Stock that the program is to leave on the part, as for finishing; deviations count from it.</source>
        <translation>Material, das das Programm am Fertigteil stehen lassen soll, etwa zum Schlichten; Abweichungen zählen ab dort.</translation>
    </message>
</context>
<context>
    <name>CycleTime</name>
    <message>
        <source>Cycle time to this block / of the program</source>
        <translation>Laufzeit bis zu diesem Satz / des Programms</translation>
    </message>
    <message>
        <source>Feed %1, rapid %2, dwell %3, tool changes %4</source>
        <translation>Vorschub %1, Eilgang %2, Verweilen %3, Werkzeugwechsel %4</translation>
    </message>
    <message>
        <source>Default machine values; enter those of your machine in the Setup panel.</source>
        <translation>Vorgabewerte der Maschine; tragen Sie die Ihrer Maschine unter „Aufspannung“ ein.</translation>
    </message>
    <message>
        <source>%1 moves have no feed rate; the maximum is assumed.</source>
        <translation>%1 Bewegungen haben keinen Vorschub; der maximale wird angenommen.</translation>
    </message>
</context>
<context>
    <name>DeviationChart</name>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>below %1 mm: %2</source>
        <translation>unter %1 mm: %2</translation>
    </message>
    <message>
        <source>above %1 mm: %2</source>
        <translation>über %1 mm: %2</translation>
    </message>
    <message>
        <source>%1 to %2 mm: %3</source>
        <translation>%1 bis %2 mm: %3</translation>
    </message>
</context>
<context>
    <name>DockTitles</name>
    <message>
        <source>Float or dock this panel</source>
        <translation>Diesen Bereich lösen oder andocken</translation>
    </message>
    <message>
        <source>Close this panel</source>
        <translation>Diesen Bereich schließen</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>NC Program</source>
        <translation>NC-Programm</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Abstimmung</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>Haltepunkte</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Fertigteil</translation>
    </message>
</context>
<context>
    <name>DocumentTitle</name>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>setup</source>
        <translation>Aufspannung</translation>
    </message>
</context>
<context>
    <name>EditCommands</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>Move the selected text to the clipboard</source>
        <translation>Den gewählten Text in die Zwischenablage verschieben</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected text to the clipboard</source>
        <translation>Den gewählten Text in die Zwischenablage kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Insert the text from the clipboard</source>
        <translation>Den Text aus der Zwischenablage einfügen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete the selected text</source>
        <translation>Den gewählten Text löschen</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>Alles &amp;markieren</translation>
    </message>
    <message>
        <source>Select all of the text</source>
        <translation>Den ganzen Text markieren</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Suchen …</translation>
    </message>
    <message>
        <source>Find text in the NC program</source>
        <translation>Text im NC-Programm suchen</translation>
    </message>
    <message>
        <source>R&amp;eplace…</source>
        <translation>E&amp;rsetzen …</translation>
    </message>
    <message>
        <source>Find text in the NC program and replace it</source>
        <translation>Text im NC-Programm suchen und ersetzen</translation>
    </message>
    <message>
        <source>Find &amp;Next</source>
        <translation>&amp;Weitersuchen</translation>
    </message>
    <message>
        <source>Go to the next match</source>
        <translation>Zum nächsten Treffer gehen</translation>
    </message>
    <message>
        <source>Find Pre&amp;vious</source>
        <translation>&amp;Vorheriger Treffer</translation>
    </message>
    <message>
        <source>Go to the previous match</source>
        <translation>Zum vorherigen Treffer gehen</translation>
    </message>
    <message>
        <source>Run to Cur&amp;sor</source>
        <translation>Bis zum &amp;Cursor ausführen</translation>
    </message>
    <message>
        <source>Show the stock after the cursor line</source>
        <translation>Das Rohteil nach der Cursorzeile zeigen</translation>
    </message>
    <message>
        <source>Toggle &amp;Breakpoint</source>
        <translation>&amp;Haltepunkt umschalten</translation>
    </message>
    <message>
        <source>Set or remove a breakpoint at the cursor line</source>
        <translation>Einen Haltepunkt in der Cursorzeile setzen oder entfernen</translation>
    </message>
    <message>
        <source>Undo the last change where the focus is: program text, or setup, tuning and machine</source>
        <translation>Die letzte Änderung dort rückgängig machen, wo der Fokus ist: Programmtext oder Aufspannung, Abstimmung und Maschine</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>Die zuletzt rückgängig gemachte Änderung wiederholen</translation>
    </message>
</context>
<context>
    <name>EditedElsewhereBar</name>
    <message>
        <source>%1 has unsaved changes in another Proveout window (process %2 on %3). Save or discard them there before you edit the file here.</source>
        <translation>%1 hat nicht gespeicherte Änderungen in einem anderen Proveout-Fenster (Prozess %2 auf %3). Speichern oder verwerfen Sie diese dort, bevor Sie die Datei hier bearbeiten.</translation>
    </message>
</context>
<context>
    <name>EditorPanel</name>
    <message>
        <source>NC program</source>
        <translation>NC-Programm</translation>
    </message>
    <message>
        <source>Read-only, with lines truncated: line %1 has more than %2 characters.</source>
        <translation>Schreibgeschützt, mit gekürzten Zeilen: Zeile %1 hat mehr als %2 Zeichen.</translation>
    </message>
    <message>
        <source>Read-only: the file is larger than 1 GB.</source>
        <translation>Schreibgeschützt: Die Datei ist größer als 1 GB.</translation>
    </message>
    <message>
        <source>F&amp;ollow Program</source>
        <translation>Dem Pr&amp;ogramm folgen</translation>
    </message>
    <message>
        <source>Keep the current line in view during playback; typing, clicking or scrolling in the text turns this off until playback is restarted</source>
        <translation>Die aktuelle Zeile beim Abspielen sichtbar halten; Tippen, Klicken oder Rollen im Text schaltet dies aus, bis das Abspielen neu gestartet wird</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>full resolution, largest error %1 mm</source>
        <translation>volle Auflösung, größter Fehler %1 mm</translation>
    </message>
    <message>
        <source>largest measured error %1 mm, not guaranteed</source>
        <translation>größter gemessener Fehler %1 mm, nicht garantiert</translation>
    </message>
    <message>
        <source>largest error %1 mm exceeds the allowance of %2 mm</source>
        <translation>größter Fehler %1 mm überschreitet die zulässigen %2 mm</translation>
    </message>
    <message>
        <source>largest error %1 mm, certified within %2 mm at every z-map point</source>
        <translation>größter Fehler %1 mm, zertifiziert bis %2 mm an jedem Z-Map-Punkt</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>Exported %1: %2</source>
        <translation>%1 exportiert: %2</translation>
    </message>
    <message>
        <source>%1: %2 triangles, %3</source>
        <translation>%1: %2 Dreiecke, %3</translation>
    </message>
    <message>
        <source>largest error %1 mm, certified within %2 mm everywhere</source>
        <translation>größter Fehler %1 mm, überall zertifiziert innerhalb %2 mm</translation>
    </message>
    <message>
        <source>(block %1 of %2)</source>
        <translation>(Satz %1 von %2)</translation>
    </message>
    <message>
        <source>Saved %1: the stock for the next setup</source>
        <translation>%1 gespeichert: das Rohteil für die nächste Aufspannung</translation>
    </message>
    <message>
        <source>largest error %1 mm, certified within %2 mm everywhere but at walls</source>
        <translation>größter Fehler %1 mm, außer an Wänden überall zertifiziert innerhalb %2 mm</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Range: %1 to %2</source>
        <comment>the second one with its unit</comment>
        <translation>Bereich: %1 bis %2</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Vorgabe: %1</translation>
    </message>
</context>
<context>
    <name>FileChangedBar</name>
    <message>
        <source>Read the file again; your unsaved changes are lost</source>
        <translation>Die Datei neu lesen; Ihre nicht gespeicherten Änderungen gehen verloren</translation>
    </message>
    <message>
        <source>%1 was deleted or renamed on disk. Saving creates it again.</source>
        <translation>%1 wurde auf dem Datenträger gelöscht oder umbenannt. Speichern legt die Datei wieder an.</translation>
    </message>
    <message>
        <source>%1 is no longer a file. Save under another name.</source>
        <translation>%1 ist keine Datei mehr. Unter anderem Namen speichern.</translation>
    </message>
    <message>
        <source>%1 has changed on disk. Reloading discards your unsaved changes.</source>
        <translation>%1 wurde auf dem Datenträger geändert. Neu laden verwirft Ihre nicht gespeicherten Änderungen.</translation>
    </message>
    <message>
        <source>%1 has changed on disk.</source>
        <translation>%1 wurde auf dem Datenträger geändert.</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>Neu &amp;laden</translation>
    </message>
    <message>
        <source>&amp;Keep My Version</source>
        <translation>&amp;Meine Version behalten</translation>
    </message>
    <message>
        <source>Continue with the version in this window</source>
        <translation>Mit der Version dieses Fensters weiterarbeiten</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>&amp;Vergleichen …</translation>
    </message>
    <message>
        <source>Show the differences between the file and this window</source>
        <translation>Die Unterschiede zwischen der Datei und diesem Fenster zeigen</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Create an empty NC program</source>
        <translation>Ein leeres NC-Programm anlegen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open an NC program or a job</source>
        <translation>Ein NC-Programm oder einen Auftrag öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the NC program, and its job if it has one</source>
        <translation>Das NC-Programm und, falls vorhanden, seinen Auftrag speichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the NC program under another name</source>
        <translation>Das NC-Programm unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>Save &amp;Job As…</source>
        <translation>Auf&amp;trag speichern unter …</translation>
    </message>
    <message>
        <source>Save stock, tools and parameters of the program as a job</source>
        <translation>Rohteil, Werkzeuge und Parameter des Programms als Auftrag speichern</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close Proveout</source>
        <translation>Proveout schließen</translation>
    </message>
    <message>
        <source>Save S&amp;tock…</source>
        <translation>&amp;Rohteil speichern …</translation>
    </message>
    <message>
        <source>Save the remaining stock for the next setup</source>
        <translation>Das verbleibende Rohteil für die nächste Aufspannung speichern</translation>
    </message>
</context>
<context>
    <name>FileFlow</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save NC Program As</source>
        <translation>NC-Programm speichern unter</translation>
    </message>
    <message>
        <source>Save Job As</source>
        <translation>Auftrag speichern unter</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Drop a single file from this computer.</source>
        <translation>Legen Sie eine einzelne Datei von diesem Rechner ab.</translation>
    </message>
    <message>
        <source>A folder cannot be opened; drop an NC program or a job.</source>
        <translation>Ein Ordner lässt sich nicht öffnen; legen Sie ein NC-Programm oder einen Auftrag ab.</translation>
    </message>
    <message>
        <source>A mesh is not a program. To cut it, choose it as the stock in the Setup panel.</source>
        <translation>Ein Netz ist kein Programm. Wählen Sie es unter „Aufspannung“ als Rohteil, um es zu bearbeiten.</translation>
    </message>
    <message>
        <source>Export Decimated Mesh</source>
        <translation>Dezimiertes Netz exportieren</translation>
    </message>
    <message>
        <source>Export Full-Resolution Mesh</source>
        <translation>Netz in voller Auflösung exportieren</translation>
    </message>
    <message>
        <source>Export in progress</source>
        <translation>Laufender Export</translation>
    </message>
    <message>
        <source>A file is still being written.</source>
        <translation>Eine Datei wird noch geschrieben.</translation>
    </message>
    <message>
        <source>Close after the file is written, or discard the file and close now?</source>
        <translation>Nach dem Schreiben der Datei schließen, oder die Datei verwerfen und jetzt schließen?</translation>
    </message>
    <message>
        <source>&amp;Wait for the File</source>
        <translation>Auf die Datei &amp;warten</translation>
    </message>
    <message>
        <source>&amp;Discard the File</source>
        <translation>Datei &amp;verwerfen</translation>
    </message>
    <message>
        <source>Save Stock</source>
        <translation>Rohteil speichern</translation>
    </message>
    <message>
        <source>Saved as %1; the other version is still in %2.</source>
        <translation>Als %1 gespeichert; die andere Version bleibt in %2.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>. The setup has not been saved as a job.</source>
        <translation>. Die Aufspannung ist nicht als Auftrag gespeichert.</translation>
    </message>
    <message>
        <source>The new program has not been saved.</source>
        <translation>Das neue Programm ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 hat nicht gespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>The setup has not been saved as a job.</source>
        <translation>Die Aufspannung ist nicht als Auftrag gespeichert.</translation>
    </message>
    <message>
        <source>The setup of %1 has unsaved changes.</source>
        <translation>Die Aufspannung von %1 hat nicht gespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Save the changes first?</source>
        <translation>Die Änderungen vorher speichern?</translation>
    </message>
    <message>
        <source>NC programs and jobs (%1)</source>
        <translation>NC-Programme und Aufträge (%1)</translation>
    </message>
</context>
<context>
    <name>FindBar</name>
    <message>
        <source>Replacing…</source>
        <translation>Ersetzen läuft …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Ersetzen durch</translation>
    </message>
    <message>
        <source>Previous match (Shift+F3)</source>
        <translation>Vorheriger Treffer (Umschalt+F3)</translation>
    </message>
    <message>
        <source>Previous match</source>
        <translation>Vorheriger Treffer</translation>
    </message>
    <message>
        <source>Next match (F3)</source>
        <translation>Nächster Treffer (F3)</translation>
    </message>
    <message>
        <source>Next match</source>
        <translation>Nächster Treffer</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Replace all matches</source>
        <translation>Alle Treffer ersetzen</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Not found.</source>
        <translation>Nicht gefunden.</translation>
    </message>
    <message numerus="yes">
        <source>%n replaced.</source>
        <translation>
            <numerusform>%n Stelle ersetzt.</numerusform>
            <numerusform>%n Stellen ersetzt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>Ganze Wörter</translation>
    </message>
    <message>
        <source>Find G2 in G2X10, but not in G21 or G2.1</source>
        <translation>G2 in G2X10 finden, aber nicht in G21 oder G2.1</translation>
    </message>
    <message>
        <source>more than %1</source>
        <comment>matches</comment>
        <translation>mehr als %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>matches</comment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 found</source>
        <comment>matches</comment>
        <translation>%1 gefunden</translation>
    </message>
</context>
<context>
    <name>FixtureEditor</name>
    <message>
        <source>Vice</source>
        <translation>Schraubstock</translation>
    </message>
    <message>
        <source>Step clamp</source>
        <translation>Spanneisen</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Vice…</source>
        <translation>Schraubstock…</translation>
    </message>
    <message>
        <source>Step Clamp…</source>
        <translation>Spanneisen…</translation>
    </message>
    <message>
        <source>Bed</source>
        <translation>Bett</translation>
    </message>
    <message>
        <source>Moving jaw</source>
        <translation>Bewegliche Backe</translation>
    </message>
    <message>
        <source>Fixed jaw</source>
        <translation>Feste Backe</translation>
    </message>
    <message>
        <source>Bolt</source>
        <translation>Schraube</translation>
    </message>
    <message>
        <source>Clamp</source>
        <translation>Spanneisen</translation>
    </message>
    <message>
        <source>There is already a fixture &quot;%1&quot;.</source>
        <translation>Es gibt schon ein Spannmittel „%1“.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a fixture at the stock</source>
        <translation>Ein Spannmittel am Rohteil hinzufügen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Add a copy of the selected fixture</source>
        <translation>Eine Kopie des gewählten Spannmittels hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected fixture</source>
        <translation>Das gewählte Spannmittel entfernen</translation>
    </message>
    <message>
        <source>Name of the fixture</source>
        <translation>Name des Spannmittels</translation>
    </message>
    <message>
        <source>Findings name the fixture like this</source>
        <translation>So nennen Befunde das Spannmittel</translation>
    </message>
    <message>
        <source>Mesh (STL)…</source>
        <translation>Netz (STL)…</translation>
    </message>
    <message>
        <source>Mesh of a Fixture</source>
        <translation>Netz eines Spannmittels</translation>
    </message>
    <message>
        <source>Mesh (%1)</source>
        <translation>Netz (%1)</translation>
    </message>
    <message>
        <source>Not read</source>
        <translation>Nicht gelesen</translation>
    </message>
</context>
<context>
    <name>ForeignNotice</name>
    <message>
        <source>Read As</source>
        <translation>Lesen als</translation>
    </message>
    <message>
        <source>Choose the dialect of the program</source>
        <translation>Den Dialekt des Programms wählen</translation>
    </message>
</context>
<context>
    <name>GridField</name>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Automatic grid spacing</source>
        <translation>Automatische Rasterweite</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
</context>
<context>
    <name>GuideWindow</name>
    <message>
        <source>User Guide – Proveout</source>
        <translation>Benutzerhandbuch – Proveout</translation>
    </message>
    <message>
        <source>← Back</source>
        <translation>← Zurück</translation>
    </message>
    <message>
        <source>Forward →</source>
        <translation>Vor →</translation>
    </message>
    <message>
        <source>User guide pages</source>
        <translation>Seiten des Benutzerhandbuchs</translation>
    </message>
    <message>
        <source>User guide page</source>
        <translation>Seite des Benutzerhandbuchs</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>&amp;User Guide</source>
        <translation>&amp;Benutzerhandbuch</translation>
    </message>
    <message>
        <source>Show the page about the panel that has the focus</source>
        <translation>Die Seite zu dem Bereich zeigen, der den Fokus hat</translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>List all keyboard shortcuts and mouse actions</source>
        <translation>Alle Tasten und Mausaktionen auflisten</translation>
    </message>
    <message>
        <source>&amp;Start Page</source>
        <translation>&amp;Startseite</translation>
    </message>
    <message>
        <source>Show samples and recent files</source>
        <translation>Beispiele und zuletzt geöffnete Dateien zeigen</translation>
    </message>
    <message>
        <source>&amp;About Proveout</source>
        <translation>Ü&amp;ber Proveout</translation>
    </message>
    <message>
        <source>Version, licence and the paper</source>
        <translation>Version, Lizenz und der Aufsatz</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Über &amp;Qt</translation>
    </message>
    <message>
        <source>About the user interface library</source>
        <translation>Über die Bibliothek der Oberfläche</translation>
    </message>
</context>
<context>
    <name>IgnoredCodesField</name>
    <message>
        <source>M%1 (%2×)</source>
        <translation>M%1 (%2×)</translation>
    </message>
    <message>
        <source>M%1 %2 (%3×)</source>
        <translation>M%1 %2 (%3×)</translation>
    </message>
    <message>
        <source>Ignored in this program: %1</source>
        <translation>In diesem Programm ignoriert: %1</translation>
    </message>
    <message>
        <source>for example 16, 24, 25</source>
        <translation>zum Beispiel 16, 24, 25</translation>
    </message>
</context>
<context>
    <name>IslandsModel</name>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Tiefe, mm</translation>
    </message>
    <message>
        <source>Area, mm²</source>
        <translation>Fläche, mm²</translation>
    </message>
    <message>
        <source>Volume, mm³</source>
        <translation>Volumen, mm³</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
</context>
<context>
    <name>JobSteps</name>
    <message>
        <source>Tool T%1</source>
        <translation>Werkzeug T%1</translation>
    </message>
    <message>
        <source>Tool table</source>
        <translation>Werkzeugtabelle</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>Decimation method</source>
        <translation>Dezimierungsverfahren</translation>
    </message>
    <message>
        <source>Decimation parameters</source>
        <translation>Dezimierungsparameter</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Limits of rules</source>
        <translation>Grenzen der Regeln</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>Regeln</translation>
    </message>
    <message>
        <source>Waiver</source>
        <translation>Freigabe</translation>
    </message>
    <message>
        <source>Fixture %1</source>
        <translation>Spannmittel %1</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>Design part</source>
        <translation>Fertigteil</translation>
    </message>
</context>
<context>
    <name>Layouts</name>
    <message>
        <source>&amp;Machinist</source>
        <translation>&amp;Werkstatt</translation>
    </message>
    <message>
        <source>Program, setup and problems in front; playback in machine time</source>
        <translation>Programm, Aufspannung und Probleme vorn; Abspielen in Maschinenzeit</translation>
    </message>
    <message>
        <source>&amp;Research</source>
        <translation>&amp;Forschung</translation>
    </message>
    <message>
        <source>Tuning and plots in front; playback by blocks</source>
        <translation>Abstimmung und Diagramme vorn; Abspielen nach Sätzen</translation>
    </message>
</context>
<context>
    <name>MachineForm</name>
    <message>
        <source>Default machine values.</source>
        <translation>Vorgabewerte der Maschine.</translation>
    </message>
    <message>
        <source>Cycle time %1: feed %2, rapid %3, dwell %4, tool changes %5</source>
        <translation>Laufzeit %1: Vorschub %2, Eilgang %3, Verweilen %4, Werkzeugwechsel %5</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>Typical machines by kind and size, to begin with</source>
        <translation>Typische Maschinen nach Art und Größe, für den Anfang</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
</context>
<context>
    <name>MemoryMenu</name>
    <message>
        <source>%1 (default)</source>
        <translation>%1 (Vorgabe)</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>P&amp;lots</source>
        <translation>Dia&amp;gramme</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>&amp;Simulation</translation>
    </message>
    <message>
        <source>&amp;Mesh</source>
        <translation>&amp;Netz</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Open Sa&amp;mple</source>
        <translation>&amp;Beispiel öffnen</translation>
    </message>
    <message>
        <source>Rewind &amp;Memory</source>
        <translation>Speicher zum &amp;Zurückgehen</translation>
    </message>
    <message>
        <source>&amp;Graphics Memory</source>
        <translation>&amp;Grafikspeicher</translation>
    </message>
    <message>
        <source>L&amp;ayout</source>
        <translation>A&amp;nordnung</translation>
    </message>
</context>
<context>
    <name>MeshCommands</name>
    <message>
        <source>Export the decimated mesh as a closed solid</source>
        <translation>Das dezimierte Netz als geschlossenen Körper exportieren</translation>
    </message>
    <message>
        <source>Export the mesh with every z-map point</source>
        <translation>Das Netz mit jedem Z-Map-Punkt exportieren</translation>
    </message>
    <message>
        <source>&amp;Tune Decimation</source>
        <translation>Dezimierung &amp;abstimmen</translation>
    </message>
    <message>
        <source>Show the decimation parameters</source>
        <translation>Die Dezimierungsparameter zeigen</translation>
    </message>
    <message>
        <source>&amp;Default Parameters</source>
        <translation>Vor&amp;gabeparameter</translation>
    </message>
    <message>
        <source>Reset all decimation parameters to their defaults</source>
        <translation>Alle Dezimierungsparameter auf ihre Vorgaben zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Export Mesh…</source>
        <translation>Netz &amp;exportieren …</translation>
    </message>
    <message>
        <source>Export &amp;Full-Resolution Mesh…</source>
        <translation>Netz in &amp;voller Auflösung exportieren …</translation>
    </message>
</context>
<context>
    <name>NumberBox</name>
    <message>
        <source>%1 is out of range: %2 to %3%4.</source>
        <translation>%1 liegt außerhalb des Bereichs: %2 bis %3%4.</translation>
    </message>
</context>
<context>
    <name>OutsideQuestion</name>
    <message>
        <source>%1 uses files outside its folder:</source>
        <translation>%1 verwendet Dateien außerhalb seines Ordners:</translation>
    </message>
    <message>
        <source>Files outside the folder of the job</source>
        <translation>Dateien außerhalb des Auftragsordners</translation>
    </message>
    <message>
        <source>Allow this only if you trust the job. Your answer is remembered for this job and these files.</source>
        <translation>Erlauben Sie dies nur, wenn Sie dem Auftrag vertrauen. Ihre Antwort wird für diesen Auftrag und diese Dateien gemerkt.</translation>
    </message>
    <message>
        <source>&amp;Allow and Open</source>
        <translation>&amp;Erlauben und öffnen</translation>
    </message>
</context>
<context>
    <name>ParameterForm</name>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Back to the default: %1</source>
        <translation>Zurück zur Vorgabe: %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
</context>
<context>
    <name>PartForm</name>
    <message>
        <source>Design Part</source>
        <translation>Fertigteil</translation>
    </message>
    <message>
        <source>Mesh (%1)</source>
        <translation>Netz (%1)</translation>
    </message>
    <message>
        <source>No design part</source>
        <translation>Kein Fertigteil</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Choose the part that the stock is compared with (STL)</source>
        <translation>Das Teil wählen, mit dem das Rohteil verglichen wird (STL)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Compare the stock with no part</source>
        <translation>Das Rohteil mit keinem Teil vergleichen</translation>
    </message>
</context>
<context>
    <name>PartPanel</name>
    <message>
        <source>Open a program, then choose the part that it makes.</source>
        <translation>Öffnen Sie ein Programm und wählen Sie dann das Teil, das es herstellt.</translation>
    </message>
    <message>
        <source>Choose the part that the program makes: the stock is then compared with it.</source>
        <translation>Wählen Sie das Teil, das das Programm herstellt: das Rohteil wird dann damit verglichen.</translation>
    </message>
    <message>
        <source>Reading the part…</source>
        <translation>Fertigteil wird gelesen …</translation>
    </message>
    <message>
        <source>There is not enough memory for the part.</source>
        <translation>Für das Fertigteil reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>Checking the program and comparing the stock…</source>
        <translation>Das Programm wird geprüft und das Rohteil verglichen …</translation>
    </message>
    <message>
        <source>The program is not checked.</source>
        <translation>Das Programm wird nicht geprüft.</translation>
    </message>
    <message>
        <source>The stock is not compared with the part: see the problems.</source>
        <translation>Das Rohteil wird nicht mit dem Fertigteil verglichen: siehe Probleme.</translation>
    </message>
    <message>
        <source>Nothing is out of tolerance.</source>
        <translation>Nichts ist außer Toleranz.</translation>
    </message>
    <message>
        <source>Save Islands</source>
        <translation>Inseln speichern</translation>
    </message>
    <message>
        <source>Table (%1)</source>
        <translation>Tabelle (%1)</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>CSV speichern …</translation>
    </message>
    <message>
        <source>Save the islands as a table</source>
        <translation>Die Inseln als Tabelle speichern</translation>
    </message>
    <message>
        <source>Places out of tolerance</source>
        <translation>Stellen außer Toleranz</translation>
    </message>
</context>
<context>
    <name>PartText</name>
    <message>
        <source>Gouge</source>
        <translation>Werkstückverletzung</translation>
    </message>
    <message>
        <source>Excess</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>reached by no tool</source>
        <translation>von keinem Werkzeug erreicht</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>nicht bestimmt</translation>
    </message>
    <message>
        <source>%1, %2 mm deep, %3 mm², %4 mm³, at X%5 Y%6 Z%7</source>
        <translation>%1, %2 mm tief, %3 mm², %4 mm³, bei X%5 Y%6 Z%7</translation>
    </message>
    <message>
        <source>Line %1, T%2</source>
        <translation>Zeile %1, T%2</translation>
    </message>
    <message>
        <source>allowed: −%1 to +%2 mm</source>
        <translation>erlaubt: −%1 bis +%2 mm</translation>
    </message>
    <message>
        <source>Gouges: %1, up to %2 mm deep, %3 mm³</source>
        <translation>Werkstückverletzungen: %1, bis %2 mm tief, %3 mm³</translation>
    </message>
    <message>
        <source>Excesses: %1, up to %2 mm high, %3 mm³</source>
        <translation>Restmaterial: %1, bis %2 mm hoch, %3 mm³</translation>
    </message>
    <message>
        <source>In tolerance: deviations from %1 to %2 mm</source>
        <translation>In Toleranz: Abweichungen von %1 bis %2 mm</translation>
    </message>
    <message>
        <source>not all of it can be judged</source>
        <translation>nicht alles kann beurteilt werden</translation>
    </message>
</context>
<context>
    <name>PartView</name>
    <message>
        <source>The part is being read.</source>
        <translation>Das Fertigteil wird gelesen.</translation>
    </message>
    <message>
        <source>The part cannot be used; see Problems.</source>
        <translation>Das Fertigteil ist nicht verwendbar; siehe Probleme.</translation>
    </message>
    <message>
        <source>Not enough graphics memory for these colours.</source>
        <translation>Zu wenig Grafikspeicher für diese Farben.</translation>
    </message>
    <message>
        <source>Comparing: %1 %</source>
        <translation>Vergleich: %1 %</translation>
    </message>
    <message>
        <source>The stock cannot be compared.</source>
        <translation>Das Rohteil kann nicht verglichen werden.</translation>
    </message>
    <message>
        <source>New cuts are compared when playback stops.</source>
        <translation>Neue Schnitte werden verglichen, sobald die Wiedergabe anhält.</translation>
    </message>
</context>
<context>
    <name>PlotView</name>
    <message>
        <source>Not measured.</source>
        <translation>Nicht gemessen.</translation>
    </message>
    <message>
        <source>Play, or press %1.</source>
        <translation>Abspielen oder %1.</translation>
    </message>
    <message>
        <source>Play to measure</source>
        <translation>Zum Messen abspielen</translation>
    </message>
    <message>
        <source>Parameters changed here</source>
        <translation>Hier wurden Parameter geändert</translation>
    </message>
    <message>
        <source>%1 (log)</source>
        <translation>%1 (log)</translation>
    </message>
    <message>
        <source>Not drawn yet</source>
        <translation>Noch nicht gezeichnet</translation>
    </message>
    <message>
        <source>Upload and drawing: mean of blocks %1 to %2 (one frame)</source>
        <translation>Übertragen und Zeichnen: Mittel der Sätze %1 bis %2 (ein Bild)</translation>
    </message>
</context>
<context>
    <name>Plots</name>
    <message>
        <source>Without decimation</source>
        <translation>Ohne Dezimierung</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Fräsen</translation>
    </message>
    <message>
        <source>Decimation</source>
        <translation>Dezimierung</translation>
    </message>
    <message>
        <source>Upload</source>
        <translation>Übertragen</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Abgetragen</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Satz</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Removed Volume</source>
        <translation>Abgetragenes Volumen</translation>
    </message>
    <message>
        <source>Volume (mm³)</source>
        <translation>Volumen (mm³)</translation>
    </message>
    <message>
        <source>Time per Block</source>
        <translation>Zeit je Satz</translation>
    </message>
    <message>
        <source>Time (ms)</source>
        <translation>Zeit (ms)</translation>
    </message>
    <message>
        <source>Axial depth</source>
        <translation>Axiale Zustellung</translation>
    </message>
    <message>
        <source>Radial engagement</source>
        <translation>Radialer Eingriff</translation>
    </message>
    <message>
        <source>Axial Depth</source>
        <translation>Axiale Zustellung</translation>
    </message>
    <message>
        <source>Depth ap (mm)</source>
        <translation>Tiefe ap (mm)</translation>
    </message>
    <message>
        <source>Radial Engagement</source>
        <translation>Radialer Eingriff</translation>
    </message>
    <message>
        <source>Width ae (mm)</source>
        <translation>Breite ae (mm)</translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation>Zeitspanvolumen</translation>
    </message>
    <message>
        <source>Volume per length</source>
        <translation>Volumen je Länge</translation>
    </message>
    <message>
        <source>Removal Rate</source>
        <translation>Zeitspanvolumen</translation>
    </message>
    <message>
        <source>MRR (mm³/min)</source>
        <translation>Q (mm³/min)</translation>
    </message>
    <message>
        <source>Volume per Length</source>
        <translation>Volumen je Länge</translation>
    </message>
    <message>
        <source>Volume (mm³/mm)</source>
        <translation>Abtrag (mm³/mm)</translation>
    </message>
</context>
<context>
    <name>PlotsPanel</name>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Show or hide the plot &quot;%1&quot;</source>
        <translation>Das Diagramm „%1“ ein- oder ausblenden</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Mitlaufen</translation>
    </message>
    <message>
        <source>Keep the current block in view; dragging a plot turns this off</source>
        <translation>Den aktuellen Satz sichtbar halten; Ziehen eines Diagramms schaltet dies aus</translation>
    </message>
    <message>
        <source>Export Plot</source>
        <translation>Diagramm exportieren</translation>
    </message>
    <message>
        <source>Export as &amp;CSV…</source>
        <translation>Als &amp;CSV exportieren …</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Export as &amp;PNG…</source>
        <translation>Als &amp;PNG exportieren …</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>Export as &amp;SVG…</source>
        <translation>Als &amp;SVG exportieren …</translation>
    </message>
    <message>
        <source>SVG (*.svg)</source>
        <translation>SVG (*.svg)</translation>
    </message>
    <message>
        <source>C&amp;opy Data as CSV</source>
        <translation>Daten als CSV &amp;kopieren</translation>
    </message>
    <message>
        <source>Show &amp;All Blocks</source>
        <translation>&amp;Alle Sätze zeigen</translation>
    </message>
</context>
<context>
    <name>ProblemCommands</name>
    <message>
        <source>&amp;Next Problem</source>
        <translation>&amp;Nächstes Problem</translation>
    </message>
    <message>
        <source>Go to the line of the next problem</source>
        <translation>Zur Zeile des nächsten Problems gehen</translation>
    </message>
    <message>
        <source>&amp;Previous Problem</source>
        <translation>&amp;Vorheriges Problem</translation>
    </message>
    <message>
        <source>Go to the line of the previous problem</source>
        <translation>Zur Zeile des vorherigen Problems gehen</translation>
    </message>
    <message>
        <source>&amp;Rules…</source>
        <translation>&amp;Regeln …</translation>
    </message>
    <message>
        <source>Choose the rules of the check, and their limits</source>
        <translation>Die Regeln der Prüfung und ihre Grenzen wählen</translation>
    </message>
</context>
<context>
    <name>ProblemsModel</name>
    <message>
        <source>Severity</source>
        <translation>Schwere</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Abhilfe</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Results after this are unverified.</source>
        <translation>Die Ergebnisse danach sind ungeprüft.</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Akzeptiert</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>Check it yourself; then accept it in the context menu.</source>
        <translation>Selbst prüfen; dann im Kontextmenü akzeptieren.</translation>
    </message>
    <message>
        <source>Lines %1 to %2, %3 times.</source>
        <translation>Zeilen %1 bis %2, %3-mal.</translation>
    </message>
    <message>
        <source>Largest value: %1; limit: %2 %3.</source>
        <translation>Größter Wert: %1; Grenze: %2 %3.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Waived by %1: %2</source>
        <translation>Freigegeben durch %1: %2</translation>
    </message>
    <message>
        <source>Waived</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Of the check before the last change</source>
        <translation>Aus der Prüfung vor der letzten Änderung</translation>
    </message>
</context>
<context>
    <name>ProblemsPanel</name>
    <message>
        <source>Waived</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Remove the Waiver</source>
        <translation>Freigabe entfernen</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>No problems found.</source>
        <translation>Keine Probleme gefunden.</translation>
    </message>
    <message>
        <source>Go to Line</source>
        <translation>Zur Zeile gehen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Ignore M%1: It Moves No Axis</source>
        <translation>M%1 ignorieren: bewegt keine Achse</translation>
    </message>
    <message>
        <source>Open a program to see its problems.</source>
        <translation>Öffnen Sie ein Programm, um seine Probleme zu sehen.</translation>
    </message>
    <message>
        <source>Reading the program; no problems so far.</source>
        <translation>Das Programm wird gelesen; bisher keine Probleme.</translation>
    </message>
    <message>
        <source>Not simulated yet; no problems in the program text.</source>
        <translation>Noch nicht simuliert; keine Probleme im Programmtext.</translation>
    </message>
    <message>
        <source>No problems up to block %1 of %2.</source>
        <translation>Keine Probleme bis Satz %1 von %2.</translation>
    </message>
    <message>
        <source>Ignore All Unknown M Codes of This Program</source>
        <translation>Alle unbekannten M-Befehle dieses Programms ignorieren</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>Checking the program; no problems so far.</source>
        <translation>Das Programm wird geprüft; bisher keine Probleme.</translation>
    </message>
    <message>
        <source>Accept Without a Check, for All Programs</source>
        <translation>Ohne Prüfung akzeptieren, für alle Programme</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter the problems</source>
        <translation>Probleme filtern</translation>
    </message>
    <message>
        <source>Show only the rows that contain this text</source>
        <translation>Nur Zeilen zeigen, die diesen Text enthalten</translation>
    </message>
    <message>
        <source>since the last check: %1 new, %2 gone</source>
        <translation>seit der letzten Prüfung: %1 neu, %2 behoben</translation>
    </message>
    <message>
        <source>Withdraw the Waiver</source>
        <translation>Freigabe zurücknehmen</translation>
    </message>
    <message>
        <source>Waive…</source>
        <translation>Freigeben …</translation>
    </message>
    <message>
        <source>Turn This Rule Off in the Job</source>
        <translation>Diese Regel im Auftrag ausschalten</translation>
    </message>
    <message>
        <source>Turn It Off for T%1</source>
        <translation>Für T%1 ausschalten</translation>
    </message>
    <message>
        <source>New: %1</source>
        <translation>Neu: %1</translation>
    </message>
    <message>
        <source>Gone: %1</source>
        <translation>Behoben: %1</translation>
    </message>
    <message>
        <source>No problems found (%1).</source>
        <translation>Keine Probleme gefunden (%1).</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft…</translation>
    </message>
</context>
<context>
    <name>RecentMenu</name>
    <message>
        <source>Clear List</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (fehlt)</translation>
    </message>
    <message>
        <source>File not found.</source>
        <translation>Datei nicht gefunden.</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>in the backup</source>
        <translation>in der Sicherung</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>Discard unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Discard the unsaved changes of %1?</source>
        <translation>Die nicht gespeicherten Änderungen von %1 verwerfen?</translation>
    </message>
    <message>
        <source>The backup will be deleted. The file on disk is not changed.</source>
        <translation>Die Sicherung wird gelöscht. Die Datei auf dem Datenträger wird nicht geändert.</translation>
    </message>
</context>
<context>
    <name>RecoveryBar</name>
    <message>
        <source>Proveout did not close normally. These unsaved changes can be restored:</source>
        <translation>Proveout wurde nicht normal beendet. Diese nicht gespeicherten Änderungen lassen sich wiederherstellen:</translation>
    </message>
    <message>
        <source>program and setup</source>
        <translation>Programm und Aufspannung</translation>
    </message>
    <message>
        <source>program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>%1 (%2), %3</source>
        <translation>%1 (%2), %3</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Open the backup as unsaved changes; the file is not changed</source>
        <translation>Die Sicherung als nicht gespeicherte Änderungen öffnen; die Datei wird nicht geändert</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Vergleichen …</translation>
    </message>
    <message>
        <source>Show the differences between the backup and the file</source>
        <translation>Die Unterschiede zwischen der Sicherung und der Datei zeigen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Delete the backup; the file is not changed</source>
        <translation>Die Sicherung löschen; die Datei wird nicht geändert</translation>
    </message>
</context>
<context>
    <name>RulesDialog</name>
    <message>
        <source>Rules of the Check</source>
        <translation>Regeln der Prüfung</translation>
    </message>
    <message>
        <source>The job file keeps these settings. How deep, wide and fast a tool may cut is in the tool table; the limits of the machine are in its values.</source>
        <translation>Die Auftragsdatei speichert diese Einstellungen. Wie tief, breit und schnell ein Werkzeug schneiden darf, steht in der Werkzeugtabelle; die Grenzwerte der Maschine stehen bei deren Werten.</translation>
    </message>
    <message>
        <source>Other limits for single tools</source>
        <translation>Andere Grenzwerte für einzelne Werkzeuge</translation>
    </message>
</context>
<context>
    <name>RunToEnd</name>
    <message>
        <source>stock after block %1 of %2</source>
        <translation>Rohteil nach Satz %1 von %2</translation>
    </message>
    <message>
        <source>Program not run to the end</source>
        <translation>Programm nicht bis zum Ende ausgeführt</translation>
    </message>
    <message>
        <source>The simulation is at block %1 of %2.</source>
        <translation>Die Simulation steht bei Satz %1 von %2.</translation>
    </message>
    <message>
        <source>Use the stock as it is now, or run the program to the end first?</source>
        <translation>Das Rohteil im jetzigen Stand verwenden oder das Programm zuerst bis zum Ende ausführen?</translation>
    </message>
    <message>
        <source>&amp;Run to the End First</source>
        <translation>&amp;Zuerst bis zum Ende ausführen</translation>
    </message>
    <message>
        <source>&amp;Use Stock as Is</source>
        <translation>&amp;Jetzigen Stand verwenden</translation>
    </message>
    <message>
        <source>Run to the End</source>
        <translation>Bis zum Ende ausführen</translation>
    </message>
    <message>
        <source>Running the program to the end…</source>
        <translation>Das Programm wird bis zum Ende ausgeführt …</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>Core insert</source>
        <translation>Kerneinsatz</translation>
    </message>
    <message>
        <source>Mouse case</source>
        <translation>Mausgehäuse</translation>
    </message>
</context>
<context>
    <name>SaveQuestion</name>
    <message>
        <source>File changed on disk</source>
        <translation>Datei auf dem Datenträger geändert</translation>
    </message>
    <message>
        <source>%1 has changed on disk.</source>
        <translation>%1 wurde auf dem Datenträger geändert.</translation>
    </message>
    <message>
        <source>Another program or window wrote it at %1. Saving here would overwrite those changes.

Keep Both saves your version as a new file in the same folder.</source>
        <translation>Ein anderes Programm oder Fenster hat sie um %1 geschrieben. Speichern würde diese Änderungen überschreiben.

„Beide behalten“ speichert Ihre Version als neue Datei im selben Ordner.</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>Über&amp;schreiben</translation>
    </message>
    <message>
        <source>&amp;Keep Both</source>
        <translation>&amp;Beide behalten</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>&amp;Vergleichen …</translation>
    </message>
    <message>
        <source>Stock in use</source>
        <translation>Rohteil in Gebrauch</translation>
    </message>
    <message>
        <source>%1 is the stock of the open job.</source>
        <translation>%1 ist das Rohteil des geöffneten Auftrags.</translation>
    </message>
    <message>
        <source>If you overwrite it, the job will start from its own result the next time it is opened.</source>
        <translation>Wenn Sie es überschreiben, geht der Auftrag beim nächsten Öffnen von seinem eigenen Ergebnis aus.</translation>
    </message>
</context>
<context>
    <name>SetupPanel</name>
    <message>
        <source>%1 × %2 points, spacing %3 × %4 mm; needs about %5, at most %6</source>
        <translation>%1 × %2 Punkte im Abstand von %3 × %4 mm; braucht etwa %5, höchstens %6</translation>
    </message>
    <message>
        <source>Stock and grid</source>
        <translation>Rohteil und Raster</translation>
    </message>
    <message>
        <source>Fit to program</source>
        <translation>An Programm anpassen</translation>
    </message>
    <message>
        <source>Fit the stock to the toolpath</source>
        <translation>Das Rohteil an den Werkzeugweg anpassen</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Tools missing from the table: %1</source>
        <translation>In der Tabelle fehlende Werkzeuge: %1</translation>
    </message>
    <message>
        <source>Add missing tools (⌀ 10 mm assumed)</source>
        <translation>Fehlende Werkzeuge aufnehmen (⌀ 10 mm angenommen)</translation>
    </message>
    <message>
        <source>Add these tools; then enter the sizes of your cutters</source>
        <translation>Diese Werkzeuge aufnehmen; danach die Maße Ihrer Fräser eintragen</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Spannmittel</translation>
    </message>
</context>
<context>
    <name>Severity</name>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Machining fault</source>
        <translation>Bearbeitungsfehler</translation>
    </message>
</context>
<context>
    <name>SimulateCommands</name>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Play or pause the program</source>
        <translation>Das Programm abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Play from Sta&amp;rt</source>
        <translation>Von An&amp;fang abspielen</translation>
    </message>
    <message>
        <source>Go to the uncut stock and play</source>
        <translation>Zum ungefrästen Rohteil gehen und abspielen</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Stopp</translation>
    </message>
    <message>
        <source>Stop and go back to the uncut stock</source>
        <translation>Anhalten und zum ungefrästen Rohteil zurückgehen</translation>
    </message>
    <message>
        <source>Go to St&amp;art</source>
        <translation>Zum A&amp;nfang</translation>
    </message>
    <message>
        <source>Go to the uncut stock</source>
        <translation>Zum ungefrästen Rohteil gehen</translation>
    </message>
    <message>
        <source>Step &amp;Back</source>
        <translation>Satz &amp;zurück</translation>
    </message>
    <message>
        <source>Go back by one block</source>
        <translation>Einen Satz zurückgehen</translation>
    </message>
    <message>
        <source>Step &amp;Forward</source>
        <translation>Satz &amp;vor</translation>
    </message>
    <message>
        <source>Execute the next block</source>
        <translation>Den nächsten Satz ausführen</translation>
    </message>
    <message>
        <source>Go to &amp;End</source>
        <translation>Zum &amp;Ende</translation>
    </message>
    <message>
        <source>Go to the end of the program</source>
        <translation>Zum Ende des Programms gehen</translation>
    </message>
    <message>
        <source>Back by 10 Blocks</source>
        <translation>10 Sätze zurück</translation>
    </message>
    <message>
        <source>Go back by 10 blocks</source>
        <translation>10 Sätze zurückgehen</translation>
    </message>
    <message>
        <source>Forward by 10 Blocks</source>
        <translation>10 Sätze vor</translation>
    </message>
    <message>
        <source>&amp;Measure Whole Program</source>
        <translation>Ganzes Programm &amp;messen</translation>
    </message>
    <message>
        <source>Execute each block that was not played yet, and measure its triangles and times for the plots</source>
        <translation>Jeden noch nicht abgespielten Satz ausführen und seine Dreiecke und Zeiten für die Diagramme messen</translation>
    </message>
    <message>
        <source>Execute the next 10 blocks</source>
        <translation>Die nächsten 10 Sätze ausführen</translation>
    </message>
    <message>
        <source>Previous &amp;Tool Change</source>
        <translation>Vorheriger &amp;Werkzeugwechsel</translation>
    </message>
    <message>
        <source>Go back to the previous tool change</source>
        <translation>Zum vorherigen Werkzeugwechsel zurückgehen</translation>
    </message>
    <message>
        <source>Next T&amp;ool Change</source>
        <translation>Nächster Werkzeugwe&amp;chsel</translation>
    </message>
    <message>
        <source>Go to the next tool change</source>
        <translation>Zum nächsten Werkzeugwechsel gehen</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>Play slower</source>
        <translation>Langsamer abspielen</translation>
    </message>
    <message>
        <source>Fa&amp;ster</source>
        <translation>Schn&amp;eller</translation>
    </message>
    <message>
        <source>Play faster</source>
        <translation>Schneller abspielen</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Back to Previo&amp;us Position</source>
        <translation>Zu&amp;rück zur vorherigen Position</translation>
    </message>
    <message>
        <source>Go back to the position before the jump to a cutting block</source>
        <translation>Zur Position vor dem Sprung zum Satz einer Stelle zurückgehen</translation>
    </message>
</context>
<context>
    <name>StartForm</name>
    <message>
        <source>Not set: %1 is assumed</source>
        <translation>Nicht gesetzt: %1 wird angenommen</translation>
    </message>
    <message>
        <source>Not set</source>
        <translation>Nicht gesetzt</translation>
    </message>
    <message>
        <source>Empty spindle</source>
        <translation>Leere Spindel</translation>
    </message>
    <message>
        <source>%1, not in the tool table</source>
        <translation>%1, nicht in der Werkzeugtabelle</translation>
    </message>
    <message>
        <source>Start position is known</source>
        <translation>Startposition ist bekannt</translation>
    </message>
    <message>
        <source>Start %1</source>
        <comment>an axis</comment>
        <translation>Start %1</translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (fehlt)</translation>
    </message>
    <message>
        <source>See what an NC program cuts before the machine does.</source>
        <translation>Sehen, was ein NC-Programm fräst, bevor es die Maschine tut.</translation>
    </message>
    <message>
        <source>Open File…</source>
        <translation>Datei öffnen …</translation>
    </message>
    <message>
        <source>Open an NC program or a job</source>
        <translation>Ein NC-Programm oder einen Auftrag öffnen</translation>
    </message>
    <message>
        <source>New Program</source>
        <translation>Neues Programm</translation>
    </message>
    <message>
        <source>Create an empty NC program</source>
        <translation>Ein leeres NC-Programm anlegen</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Or drop a file anywhere on this window.</source>
        <translation>Oder legen Sie eine Datei irgendwo auf diesem Fenster ab.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Language of the user interface</source>
        <translation>Sprache der Bedienoberfläche</translation>
    </message>
    <message>
        <source>%1
File not found.</source>
        <translation>%1
Datei nicht gefunden.</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>Zurück zu %1</translation>
    </message>
    <message>
        <source>Go back to the open document (Esc)</source>
        <translation>Zurück zum geöffneten Dokument (Esc)</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>%1 · %2 left</source>
        <translation>%1 · noch %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel this task</source>
        <translation>Diesen Vorgang abbrechen</translation>
    </message>
    <message>
        <source>Feed rate, mm/min</source>
        <translation>Vorschub, mm/min</translation>
    </message>
    <message>
        <source>Spindle speed, rpm</source>
        <translation>Spindeldrehzahl, 1/min</translation>
    </message>
    <message>
        <source>Tool in the spindle</source>
        <translation>Werkzeug in der Spindel</translation>
    </message>
    <message>
        <source>Motion blocks executed / total</source>
        <translation>Bewegungssätze ausgeführt / gesamt</translation>
    </message>
    <message>
        <source>Triangles shown</source>
        <translation>Gezeigte Dreiecke</translation>
    </message>
    <message>
        <source>Block %1 / %2</source>
        <translation>Satz %1 / %2</translation>
    </message>
    <message>
        <source>Triangles %1</source>
        <translation>Dreiecke %1</translation>
    </message>
    <message>
        <source>F rapid</source>
        <translation>F Eilgang</translation>
    </message>
    <message>
        <source>There is no stock at this point.</source>
        <translation>An dieser Stelle ist kein Rohteil.</translation>
    </message>
    <message>
        <source>Raw stock: not cut up to block %1.</source>
        <translation>Unberührtes Rohteil: bis Satz %1 nicht gefräst.</translation>
    </message>
    <message>
        <source>The program or setup has changed. Try again in a moment.</source>
        <translation>Programm oder Aufspannung wurde geändert. Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>Tool tip X in the active work offset, mm</source>
        <translation>X der Werkzeugspitze in der aktiven Nullpunktverschiebung, mm</translation>
    </message>
    <message>
        <source>Tool tip Y in the active work offset, mm</source>
        <translation>Y der Werkzeugspitze in der aktiven Nullpunktverschiebung, mm</translation>
    </message>
    <message>
        <source>Tool tip Z in the active work offset, mm</source>
        <translation>Z der Werkzeugspitze in der aktiven Nullpunktverschiebung, mm</translation>
    </message>
    <message>
        <source>Cut by block %1: line %2, tool %3.</source>
        <translation>Gefräst von Satz %1: Zeile %2, Werkzeug %3.</translation>
    </message>
</context>
<context>
    <name>StockChangedBar</name>
    <message>
        <source>%1 has changed on disk. The simulation still uses the version read before.</source>
        <translation>%1 wurde auf dem Datenträger geändert. Die Simulation verwendet noch die zuvor gelesene Version.</translation>
    </message>
    <message>
        <source>%1 was deleted or renamed on disk. The simulation still uses the version read before, but the job cannot be opened without the file.</source>
        <translation>%1 wurde auf dem Datenträger gelöscht oder umbenannt. Die Simulation verwendet noch die zuvor gelesene Version; ohne die Datei lässt sich der Auftrag aber nicht öffnen.</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>Neu &amp;laden</translation>
    </message>
    <message>
        <source>Read the stock again and simulate with it</source>
        <translation>Das Rohteil neu lesen und damit simulieren</translation>
    </message>
    <message>
        <source>&amp;Keep This Version</source>
        <translation>Diese Version &amp;behalten</translation>
    </message>
    <message>
        <source>Continue with the stock read before</source>
        <translation>Mit dem zuvor gelesenen Rohteil fortfahren</translation>
    </message>
</context>
<context>
    <name>StockForm</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>%1
Range: %2 to %3 mm
Default: %4 mm</source>
        <translation>%1
Bereich: %2 bis %3 mm
Vorgabe: %4 mm</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
</context>
<context>
    <name>StudyPanel</name>
    <message>
        <source>Measured, chosen</source>
        <translation>Gemessen, gewählt</translation>
    </message>
    <message>
        <source>Measured, current</source>
        <translation>Gemessen, aktuell</translation>
    </message>
    <message>
        <source>Rendering time</source>
        <translation>Darstellungszeit</translation>
    </message>
    <message>
        <source>Fig. %1</source>
        <translation>Abb. %1</translation>
    </message>
    <message>
        <source>This sweep does not apply to the current decimation method.</source>
        <translation>Diese Messreihe passt nicht zum aktuellen Dezimierungsverfahren.</translation>
    </message>
    <message>
        <source>Region size %1, period %2: predicted %3 s, without decimation %4 s</source>
        <translation>Regionsgröße %1, Periode %2: vorhergesagt %3 s, ohne Dezimierung %4 s</translation>
    </message>
    <message>
        <source>measured %1 s, with the current parameters %2 s</source>
        <translation>gemessen %1 s, mit den aktuellen Parametern %2 s</translation>
    </message>
    <message>
        <source>Export Figure</source>
        <translation>Abbildung exportieren</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>What the sweep varies</source>
        <translation>Was die Messreihe variiert</translation>
    </message>
    <message>
        <source>Run a sweep to see its figures here.</source>
        <translation>Starten Sie eine Messreihe, um ihre Abbildungen hier zu sehen.</translation>
    </message>
    <message>
        <source>Figure of the paper to draw</source>
        <translation>Zu zeichnende Abbildung des Aufsatzes</translation>
    </message>
    <message>
        <source>&amp;Run Sweep</source>
        <translation>&amp;Messreihe starten</translation>
    </message>
    <message>
        <source>Run the program once for each point of the paper&apos;s curves</source>
        <translation>Das Programm einmal für jeden Punkt der Kurven des Aufsatzes ausführen</translation>
    </message>
    <message>
        <source>&amp;Optimise</source>
        <translation>&amp;Optimieren</translation>
    </message>
    <message>
        <source>Choose region size and period from a short trial run, then measure them</source>
        <translation>Regionsgröße und Periode nach einem kurzen Probelauf wählen, dann messen</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>Use the chosen region size and period</source>
        <translation>Die gewählte Regionsgröße und Periode übernehmen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Figures (%1)</source>
        <translation>Abbildungen (%1)</translation>
    </message>
</context>
<context>
    <name>SurfaceProbe</name>
    <message>
        <source>X %1  Y %2  Z %3 mm (%4)</source>
        <translation>X %1  Y %2  Z %3 mm (%4)</translation>
    </message>
    <message>
        <source>Raw stock</source>
        <translation>Unberührtes Rohteil</translation>
    </message>
    <message>
        <source>Line %1, %2</source>
        <translation>Zeile %1, %2</translation>
    </message>
    <message>
        <source>Deviation %1 mm (excess)</source>
        <translation>Abweichung %1 mm (Restmaterial)</translation>
    </message>
    <message>
        <source>Deviation %1 mm (gouge)</source>
        <translation>Abweichung %1 mm (Werkstückverletzung)</translation>
    </message>
    <message>
        <source>Deviation %1 mm</source>
        <translation>Abweichung %1 mm</translation>
    </message>
</context>
<context>
    <name>TimelinePanel</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Drag to go to any block; wheel or arrow keys: one block, with Shift: more</source>
        <translation>Ziehen, um zu einem Satz zu gehen; Rad oder Pfeiltasten: ein Satz, mit Umschalt: mehr</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Playback speed; 1× is %1 blocks per second</source>
        <translation>Abspielgeschwindigkeit; 1× sind %1 Sätze je Sekunde</translation>
    </message>
    <message>
        <source>Motion blocks executed / total</source>
        <translation>Bewegungssätze ausgeführt / gesamt</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>So schnell wie möglich</translation>
    </message>
    <message>
        <source>Every block (paper mode)</source>
        <translation>Jeder Satz (wie im Aufsatz)</translation>
    </message>
    <message>
        <source>Each block is drawn before the next one is cut</source>
        <translation>Jeder Satz wird gezeichnet, bevor der nächste gefräst wird</translation>
    </message>
    <message>
        <source>There is a problem on this line.</source>
        <translation>In dieser Zeile gibt es ein Problem.</translation>
    </message>
    <message>
        <source>%1× (%2 blocks/s)</source>
        <translation>%1× (%2 Sätze/s)</translation>
    </message>
    <message>
        <source>Play by</source>
        <translation>Abspielen nach</translation>
    </message>
    <message>
        <source>Pace of playback: by block, by path length or by machine time</source>
        <translation>Takt des Abspielens: nach Sätzen, Bahnlänge oder Maschinenzeit</translation>
    </message>
    <message>
        <source>Cutting takes longer than this speed allows: playback is slower, but the stock is always correct</source>
        <translation>Das Fräsen dauert länger, als diese Geschwindigkeit erlaubt: Das Abspielen ist langsamer, aber das Rohteil stimmt immer</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Sätze</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Bahnlänge</translation>
    </message>
    <message>
        <source>Machine time</source>
        <translation>Maschinenzeit</translation>
    </message>
    <message>
        <source>%1× (%2 mm/s)</source>
        <translation>%1× (%2 mm/s)</translation>
    </message>
    <message>
        <source>%1× machine</source>
        <translation>%1× Maschine</translation>
    </message>
    <message>
        <source>Playback speed; 1× is %1 mm of path per second</source>
        <translation>Abspielgeschwindigkeit; 1× sind %1 mm Bahn je Sekunde</translation>
    </message>
    <message>
        <source>Playback speed; 1× is the speed of the machine</source>
        <translation>Abspielgeschwindigkeit; 1× ist die der Maschine</translation>
    </message>
    <message>
        <source>Actual speed %1×</source>
        <translation>Tatsächlich %1×</translation>
    </message>
    <message>
        <source>Block %1 · line %2 · %3</source>
        <translation>Satz %1 · Zeile %2 · %3</translation>
    </message>
</context>
<context>
    <name>ToolDrawing</name>
    <message>
        <source>Drawing of the tool</source>
        <translation>Zeichnung des Werkzeugs</translation>
    </message>
    <message>
        <source>The tool to scale: cutting part, shank, holder</source>
        <translation>Das Werkzeug im Maßstab: Schneide, Schaft, Halter</translation>
    </message>
</context>
<context>
    <name>ToolForm</name>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Cutter shape</source>
        <translation>Form des Fräsers</translation>
    </message>
    <message>
        <source>%1
Range: %2 to %3 %4
Default: %5 %4</source>
        <translation>%1
Bereich: %2 bis %3 %4
Vorgabe: %5 %4</translation>
    </message>
    <message>
        <source>For an arc, add the centre or the radius to its end point, as in %1 or %2; a negative radius is concave.
Default: %3</source>
        <translation>Für einen Bogen den Mittelpunkt oder Radius an den Endpunkt anfügen, wie in %1 oder %2; ein negativer Radius ist konkav.
Vorgabe: %3</translation>
    </message>
    <message>
        <source>Example: %1</source>
        <translation>Beispiel: %1</translation>
    </message>
</context>
<context>
    <name>ToolLimitsEditor</name>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenzwert</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Remove this limit</source>
        <translation>Diesen Grenzwert entfernen</translation>
    </message>
</context>
<context>
    <name>ToolNotice</name>
    <message>
        <source>Hide this notice</source>
        <translation>Diesen Hinweis ausblenden</translation>
    </message>
    <message>
        <source>The program cuts before it calls a tool; those moves are not simulated.</source>
        <translation>Das Programm fräst, bevor es ein Werkzeug aufruft; diese Bewegungen werden nicht simuliert.</translation>
    </message>
    <message>
        <source>T%1 is not in the tool table; its moves are not simulated.</source>
        <translation>T%1 steht nicht in der Werkzeugtabelle; seine Bewegungen werden nicht simuliert.</translation>
    </message>
    <message>
        <source>%1 are not in the tool table; their moves are not simulated.</source>
        <translation>%1 stehen nicht in der Werkzeugtabelle; ihre Bewegungen werden nicht simuliert.</translation>
    </message>
    <message>
        <source>Nothing is cut.</source>
        <translation>Es wird nichts gefräst.</translation>
    </message>
    <message>
        <source>Define T%1…</source>
        <translation>T%1 definieren …</translation>
    </message>
    <message>
        <source>Add T%1 to the tool table and enter its sizes</source>
        <translation>T%1 in die Werkzeugtabelle aufnehmen und seine Maße eintragen</translation>
    </message>
    <message>
        <source>Assume ⌀ 10 mm</source>
        <translation>⌀ 10 mm annehmen</translation>
    </message>
    <message>
        <source>Add the missing tools as 10 mm flat end mills, marked as assumed</source>
        <translation>Die fehlenden Werkzeuge als Schaftfräser von 10 mm aufnehmen, als angenommen gekennzeichnet</translation>
    </message>
    <message>
        <source>The sizes of %1 are not confirmed.</source>
        <translation>Die Maße von %1 sind nicht bestätigt.</translation>
    </message>
    <message>
        <source>T%1 was read from the comment in line %2: %3.</source>
        <translation>T%1 wurde aus dem Kommentar in Zeile %2 gelesen: %3.</translation>
    </message>
    <message>
        <source>The sizes of T%1 are assumed: %2.</source>
        <translation>Die Maße von T%1 sind angenommen: %2.</translation>
    </message>
    <message>
        <source>Check…</source>
        <translation>Prüfen …</translation>
    </message>
    <message>
        <source>Show T%1 in the tool table</source>
        <translation>T%1 in der Werkzeugtabelle zeigen</translation>
    </message>
    <message>
        <source>Confirm All</source>
        <translation>Alle bestätigen</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Bestätigen</translation>
    </message>
    <message>
        <source>Confirm the sizes in the tool table</source>
        <translation>Die Maße in der Werkzeugtabelle bestätigen</translation>
    </message>
    <message>
        <source>The program calls no tool; its moves are not simulated.</source>
        <translation>Das Programm ruft kein Werkzeug auf; seine Bewegungen werden nicht simuliert.</translation>
    </message>
    <message>
        <source>Results are unverified until you confirm the sizes.</source>
        <translation>Die Ergebnisse sind ungeprüft, bis Sie die Maße bestätigen.</translation>
    </message>
</context>
<context>
    <name>ToolTableEditor</name>
    <message>
        <source>T%1 is already in the table.</source>
        <translation>T%1 steht schon in der Tabelle.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Cutter</source>
        <translation>Fräser</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a tool with the next free number</source>
        <translation>Ein Werkzeug mit der nächsten freien Nummer aufnehmen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected tool</source>
        <translation>Das gewählte Werkzeug entfernen</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Tool number</source>
        <translation>Werkzeugnummer</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Defined</source>
        <translation>Definiert</translation>
    </message>
    <message>
        <source>Comment, line %1</source>
        <translation>Kommentar, Zeile %1</translation>
    </message>
    <message>
        <source>Assumed</source>
        <translation>Angenommen</translation>
    </message>
    <message>
        <source>Default sizes; enter those of your cutter, or confirm them</source>
        <translation>Vorgabemaße; die Ihres Fräsers eintragen oder sie bestätigen</translation>
    </message>
    <message>
        <source>These sizes are assumed. Enter those of your cutter, or confirm them.</source>
        <translation>Diese Maße sind angenommen. Die Ihres Fräsers eintragen oder sie bestätigen.</translation>
    </message>
    <message>
        <source>From the comment in &lt;a href=&quot;%1&quot;&gt;line %1&lt;/a&gt;: &lt;i&gt;%2&lt;/i&gt;</source>
        <translation>Aus dem Kommentar in &lt;a href=&quot;%1&quot;&gt;Zeile %1&lt;/a&gt;: &lt;i&gt;%2&lt;/i&gt;</translation>
    </message>
    <message>
        <source>Not in the comment, defaults used: %1</source>
        <translation>Nicht im Kommentar, Vorgaben verwendet: %1</translation>
    </message>
    <message>
        <source>Entered: %1</source>
        <translation>Eingegeben: %1</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Bestätigen</translation>
    </message>
    <message>
        <source>Confirm the sizes of the selected tool</source>
        <translation>Die Maße des gewählten Werkzeugs bestätigen</translation>
    </message>
    <message>
        <source>Confirm All</source>
        <translation>Alle bestätigen</translation>
    </message>
    <message>
        <source>Confirm the sizes of all tools</source>
        <translation>Die Maße aller Werkzeuge bestätigen</translation>
    </message>
    <message>
        <source>The T word that calls this tool (no unit)
Range: %1 to %2
Default: the next free number</source>
        <translation>Das T-Wort, das dieses Werkzeug ruft (ohne Einheit)
Bereich: %1 bis %2
Vorgabe: die nächste freie Nummer</translation>
    </message>
</context>
<context>
    <name>Tools</name>
    <message>
        <source>%1 (assumed)</source>
        <translation>%1 (angenommen)</translation>
    </message>
    <message>
        <source>no tool</source>
        <translation>kein Werkzeug</translation>
    </message>
</context>
<context>
    <name>TuningPanel</name>
    <message>
        <source>Open a program to see the measured effect.</source>
        <translation>Öffnen Sie ein Programm, um die gemessene Wirkung zu sehen.</translation>
    </message>
    <message>
        <source>Triangles shown: %1 of %2 (%3 %)</source>
        <translation>Gezeigte Dreiecke: %1 von %2 (%3 %)</translation>
    </message>
    <message>
        <source>Regions drawn from the z-map: %1 of %2</source>
        <translation>Aus der Z-Map gezeichnete Regionen: %1 von %2</translation>
    </message>
    <message>
        <source>Largest error: %1 mm; the allowance of %2 mm is not guaranteed while Certify is off</source>
        <translation>Größter Fehler: %1 mm; die zulässigen %2 mm sind ohne Zertifizieren nicht garantiert</translation>
    </message>
    <message>
        <source>Measured effect</source>
        <translation>Gemessene Wirkung</translation>
    </message>
    <message>
        <source>Largest error: %1 mm anywhere, within the allowance of %2 mm</source>
        <translation>Größter Fehler: %1 mm irgendwo, innerhalb der zulässigen %2 mm</translation>
    </message>
    <message>
        <source>Largest error: %1 mm at the z-map points, within the allowance of %2 mm</source>
        <translation>Größter Fehler: %1 mm an den Punkten der Z-Map, innerhalb der zulässigen %2 mm</translation>
    </message>
    <message>
        <source>Decimation is off during playback: a frame takes %1 ms without it and %2 ms with it.</source>
        <translation>Die Dezimierung ist beim Abspielen ausgeschaltet: Ein Bild dauert ohne sie %1 ms und mit ihr %2 ms.</translation>
    </message>
    <message>
        <source>Decimation is off during playback: there are only %1 triangles to draw without it.</source>
        <translation>Die Dezimierung ist beim Abspielen ausgeschaltet: Ohne sie sind nur %1 Dreiecke zu zeichnen.</translation>
    </message>
    <message>
        <source>Largest error: %1 mm anywhere but at walls, within the allowance of %2 mm</source>
        <translation>Größter Fehler: %1 mm irgendwo außer an Wänden, innerhalb der zulässigen %2 mm</translation>
    </message>
</context>
<context>
    <name>UndoCommands</name>
    <message>
        <source>Text change</source>
        <translation>Textänderung</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>The whole program was checked; no faults were found.</source>
        <translation>Das ganze Programm ist geprüft; kein Fehler wurde gefunden.</translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation>Nicht geprüft: %1.</translation>
    </message>
    <message>
        <source>Accepted without a check: %1.</source>
        <translation>Ohne Prüfung akzeptiert: %1.</translation>
    </message>
    <message>
        <source>Checking… %1 %</source>
        <translation>Prüfung … %1 %</translation>
    </message>
    <message>
        <source>SAFE</source>
        <translation>SICHER</translation>
    </message>
    <message>
        <source>FAULTS %1</source>
        <translation>FEHLER %1</translation>
    </message>
    <message>
        <source>UNVERIFIED</source>
        <translation>UNGEPRÜFT</translation>
    </message>
    <message>
        <source>Not checked: needs %1</source>
        <translation>Nicht geprüft: braucht %1</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>The whole program is being checked in the background.</source>
        <translation>Das ganze Programm wird im Hintergrund geprüft.</translation>
    </message>
    <message>
        <source>Line %1, block %2: %3</source>
        <translation>Zeile %1, Satz %2: %3</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>Waived: %1.</source>
        <translation>Freigegeben: %1.</translation>
    </message>
</context>
<context>
    <name>VerdictBadge</name>
    <message>
        <source>Click to see all findings.</source>
        <translation>Klicken, um alle Befunde zu sehen.</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>Urteil: %1</translation>
    </message>
</context>
<context>
    <name>Viewport</name>
    <message>
        <source>OpenGL is not available on this display; the 3D view is off.</source>
        <translation>OpenGL ist auf dieser Anzeige nicht verfügbar; die 3D-Ansicht ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>The OpenGL context could not be created; the 3D view is off.</source>
        <translation>Der OpenGL-Kontext ließ sich nicht anlegen; die 3D-Ansicht ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>The graphics driver does not support OpenGL 3.3; the 3D view is off.</source>
        <translation>Der Grafiktreiber unterstützt OpenGL 3.3 nicht; die 3D-Ansicht ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>%1 of %2 triangles</source>
        <translation>%1 von %2 Dreiecken</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Kreisbogen</translation>
    </message>
    <message>
        <source>Drawn from the z-map: %1 regions</source>
        <translation>Aus der Z-Map gezeichnet: %1 Regionen</translation>
    </message>
    <message>
        <source>Decimated: %1 regions</source>
        <translation>Dezimiert: %1 Regionen</translation>
    </message>
    <message>
        <source>Region border</source>
        <translation>Regionsrand</translation>
    </message>
    <message>
        <source>Triangle edge</source>
        <translation>Dreieckskante</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>A shader failed to compile; see the log.</source>
        <translation>Ein Shader ließ sich nicht kompilieren; siehe Protokoll.</translation>
    </message>
    <message>
        <source>The picture is being prepared.</source>
        <translation>Die Darstellung wird vorbereitet.</translation>
    </message>
    <message>
        <source>The picture is coarser than the grid, because the surface has %L1 triangles. Decimation reduces them.</source>
        <translation>Die Darstellung ist gröber als das Raster, weil die Oberfläche %L1 Dreiecke hat. Eine Dezimierung verringert sie.</translation>
    </message>
    <message>
        <source>The picture is coarser than the grid. Zoom in.</source>
        <translation>Die Darstellung ist gröber als das Raster. Näher heranzoomen.</translation>
    </message>
    <message>
        <source>The picture is coarser than the grid. Zoom in, or allow more graphics memory.</source>
        <translation>Die Darstellung ist gröber als das Raster. Näher heranzoomen oder mehr Grafikspeicher erlauben.</translation>
    </message>
    <message>
        <source>The grid is too large for the graphics driver; the stock is not drawn. Increase the grid spacing.</source>
        <translation>Das Raster ist zu groß für den Grafiktreiber; das Rohteil wird nicht gezeichnet. Vergrößern Sie die Rasterweite.</translation>
    </message>
    <message>
        <source>The detail region is too large for the graphics driver and is not drawn. Increase its grid spacing or make the box smaller.</source>
        <translation>Der Detailbereich ist zu groß für den Grafiktreiber und wird nicht gezeichnet. Vergrößern Sie seine Rasterweite oder verkleinern Sie den Ausschnitt.</translation>
    </message>
    <message>
        <source>Click a point on the stock.</source>
        <translation>Klicken Sie eine Stelle des Rohteils an.</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Strg+Klick</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>Design part</source>
        <translation>Fertigteil</translation>
    </message>
    <message>
        <source>Deviation from the part, mm</source>
        <translation>Abweichung vom Fertigteil, mm</translation>
    </message>
    <message>
        <source>Deviation from the part with allowance %1, mm</source>
        <translation>Abweichung vom Fertigteil mit Aufmaß %1, mm</translation>
    </message>
    <message>
        <source>&gt; %1 (excess)</source>
        <translation>&gt; %1 (Restmaterial)</translation>
    </message>
    <message>
        <source>&lt; %1 (gouge)</source>
        <translation>&lt; %1 (Werkstückverletzung)</translation>
    </message>
</context>
<context>
    <name>ViewportCommands</name>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isometrisch</translation>
    </message>
    <message>
        <source>View from the right, front and top</source>
        <translation>Von rechts vorn oben blicken</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>View along -Z</source>
        <translation>Längs -Z blicken</translation>
    </message>
    <message>
        <source>&amp;Bottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>View along +Z</source>
        <translation>Längs +Z blicken</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>View along +Y</source>
        <translation>Längs +Y blicken</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>View along -Y</source>
        <translation>Längs -Y blicken</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>View along +X</source>
        <translation>Längs +X blicken</translation>
    </message>
    <message>
        <source>Ri&amp;ght</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>View along -X</source>
        <translation>Längs -X blicken</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>Perspective or parallel projection</source>
        <translation>Perspektive oder Parallelprojektion</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Drahtgitter</translation>
    </message>
    <message>
        <source>Show the triangles and the borders of the regions</source>
        <translation>Die Dreiecke und die Ränder der Regionen zeigen</translation>
    </message>
    <message>
        <source>Tint R&amp;egions</source>
        <translation>Re&amp;gionen färben</translation>
    </message>
    <message>
        <source>Colour decimated and undecimated regions differently</source>
        <translation>Dezimierte und nicht dezimierte Regionen verschieden färben</translation>
    </message>
    <message>
        <source>Lege&amp;nd</source>
        <translation>Legen&amp;de</translation>
    </message>
    <message>
        <source>Show what the colours and lines mean</source>
        <translation>Zeigen, was Farben und Linien bedeuten</translation>
    </message>
    <message>
        <source>Hide Toolpat&amp;h</source>
        <translation>&amp;Werkzeugweg ausblenden</translation>
    </message>
    <message>
        <source>Draw no toolpath</source>
        <translation>Keinen Werkzeugweg zeichnen</translation>
    </message>
    <message>
        <source>Toolp&amp;ath Near the Cutter</source>
        <translation>Werkzeugweg nahe dem &amp;Fräser</translation>
    </message>
    <message>
        <source>Draw the toolpath of the blocks just before and after the current one</source>
        <translation>Den Werkzeugweg der Sätze kurz vor und nach dem aktuellen zeichnen</translation>
    </message>
    <message>
        <source>Wh&amp;ole Toolpath</source>
        <translation>&amp;Ganzer Werkzeugweg</translation>
    </message>
    <message>
        <source>Draw the toolpath of the whole program</source>
        <translation>Den Werkzeugweg des ganzen Programms zeichnen</translation>
    </message>
    <message>
        <source>See-Through C&amp;utter</source>
        <translation>Durchsi&amp;chtiger Fräser</translation>
    </message>
    <message>
        <source>Make the cutter transparent</source>
        <translation>Den Fräser durchsichtig zeichnen</translation>
    </message>
    <message>
        <source>Hi&amp;de Cutter</source>
        <translation>Fräser ausb&amp;lenden</translation>
    </message>
    <message>
        <source>Draw no cutter</source>
        <translation>Keinen Fräser zeichnen</translation>
    </message>
    <message>
        <source>&amp;Magnifier</source>
        <translation>De&amp;taillupe</translation>
    </message>
    <message>
        <source>Cut a box of the stock again on a much finer grid</source>
        <translation>Einen Ausschnitt des Rohteils noch einmal auf einem viel feineren Raster fräsen</translation>
    </message>
    <message>
        <source>Go to &amp;Cutting Block</source>
        <translation>Zu&amp;m fräsenden Satz gehen</translation>
    </message>
    <message>
        <source>Click a point on the stock to go to the block that cut it</source>
        <translation>Eine Stelle des Rohteils anklicken, um zum Satz zu gehen, der sie gefräst hat</translation>
    </message>
    <message>
        <source>P&amp;osition at Pointer</source>
        <translation>Positio&amp;n am Zeiger</translation>
    </message>
    <message>
        <source>Show the coordinates under the pointer, and the line that cut this point</source>
        <translation>Die Koordinaten unter dem Zeiger zeigen und die Zeile, die diese Stelle gefräst hat</translation>
    </message>
    <message>
        <source>Toolpath Through Stoc&amp;k</source>
        <translation>Wer&amp;kzeugweg durch das Rohteil</translation>
    </message>
    <message>
        <source>Show the toolpath inside and behind the stock, dimmed</source>
        <translation>Den Werkzeugweg im Rohteil und dahinter abgeschwächt zeigen</translation>
    </message>
    <message>
        <source>Show the whole stock and its fixtures</source>
        <translation>Das ganze Rohteil mit seinen Spannmitteln zeigen</translation>
    </message>
    <message>
        <source>Fi&amp;xtures</source>
        <translation>Spannmitt&amp;el</translation>
    </message>
    <message>
        <source>Draw what holds the stock</source>
        <translation>Zeichnen, was das Rohteil hält</translation>
    </message>
    <message>
        <source>Hide C&amp;ontact</source>
        <translation>K&amp;ontakt ausblenden</translation>
    </message>
    <message>
        <source>Show the cutter at the end of the block again</source>
        <translation>Den Fräser wieder am Ende des Satzes zeigen</translation>
    </message>
    <message>
        <source>Colour b&amp;y Deviation</source>
        <translation>Nach A&amp;bweichung färben</translation>
    </message>
    <message>
        <source>Colour the stock by its deviation from the design part</source>
        <translation>Das Rohteil nach seiner Abweichung vom Fertigteil färben</translation>
    </message>
    <message>
        <source>De&amp;sign Part</source>
        <translation>Fertigteil &amp;anzeigen</translation>
    </message>
    <message>
        <source>Draw the design part, see-through</source>
        <translation>Das Fertigteil durchscheinend zeichnen</translation>
    </message>
</context>
<context>
    <name>WaiveDialog</name>
    <message>
        <source>Waive a Finding</source>
        <translation>Einen Befund freigeben</translation>
    </message>
    <message>
        <source>&amp;Waive</source>
        <translation>&amp;Freigeben</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>&amp;Grund</translation>
    </message>
    <message>
        <source>&amp;Person</source>
        <translation>&amp;Person</translation>
    </message>
    <message>
        <source>It no longer counts in the verdict. If its block, size, tool or cutter changes, it counts again. The job file keeps the waiver.</source>
        <translation>Er zählt nicht mehr für das Urteil. Ändern sich Satz, Größe, Werkzeug oder Fräser, zählt er wieder. Die Auftragsdatei behält die Freigabe.</translation>
    </message>
</context>
<context>
    <name>WindowCommands</name>
    <message>
        <source>&amp;Full Screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Enter or leave full screen</source>
        <translation>Vollbild ein- oder ausschalten</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>&amp;Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Restore the default panels and view options</source>
        <translation>Bereiche und Ansichtsoptionen auf die Vorgaben zurücksetzen</translation>
    </message>
</context>
<context>
    <name>WindowToolBar</name>
    <message>
        <source>Toolbar</source>
        <translation>Werkzeugleiste</translation>
    </message>
</context>
<context>
    <name>WordTip</name>
    <message>
        <source>Value: %1</source>
        <translation>Wert: %1</translation>
    </message>
    <message>
        <source>Not set</source>
        <translation>Nicht gesetzt</translation>
    </message>
    <message>
        <source>After this line: %1</source>
        <translation>Nach dieser Zeile: %1</translation>
    </message>
    <message>
        <source>Active before and after: %1</source>
        <translation>Vorher und nachher aktiv: %1</translation>
    </message>
    <message>
        <source>Active before: %1</source>
        <translation>Vorher aktiv: %1</translation>
    </message>
    <message>
        <source>This line is not executed</source>
        <translation>Diese Zeile wird nicht ausgeführt</translation>
    </message>
    <message>
        <source>First of %1 executions</source>
        <translation>Erste von %1 Ausführungen</translation>
    </message>
</context>
<context>
    <name>WorkHub</name>
    <message>
        <source>Simulating</source>
        <translation>Simulation läuft</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Reading the program</source>
        <translation>Programm wird gelesen</translation>
    </message>
    <message>
        <source>Saving the file</source>
        <translation>Datei wird gespeichert</translation>
    </message>
    <message>
        <source>Opening the file</source>
        <translation>Datei wird geöffnet</translation>
    </message>
    <message>
        <source>Searching for the block</source>
        <translation>Satz wird gesucht</translation>
    </message>
</context>
</TS>

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>Proves out three-axis milling programs before they touch metal.</source>
        <translation>3축 밀링 프로그램을 실제 가공 전에 검증합니다.</translation>
    </message>
    <message>
        <source>The displayed surface is decimated locally while it is cut, by the method of Lee and Lee.</source>
        <translation>표시되는 곡면은 절삭되는 동안 Lee와 Lee의 방법으로 국소적으로 간략화됩니다.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. There is no warranty. Prove out every new program at the machine, too.</source>
        <translation>GNU 일반 공중 사용 허가서 버전 3 이상의 자유 소프트웨어입니다. 어떠한 보증도 없습니다. 새 프로그램은 기계에서도 반드시 검증하십시오.</translation>
    </message>
    <message>
        <source>About Proveout</source>
        <translation>Proveout 정보</translation>
    </message>
    <message>
        <source>Keys and Mouse</source>
        <translation>키와 마우스</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>명령</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>키</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D 보기</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>Left drag, or Alt+arrow keys</source>
        <translation>왼쪽 버튼으로 끌기 또는 Alt+화살표 키</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>Middle drag, or Shift+left drag</source>
        <translation>가운데 버튼으로 끌기 또는 Shift+왼쪽 버튼으로 끌기</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>확대/축소</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>휠</translation>
    </message>
    <message>
        <source>Go to the cutting block of a point</source>
        <translation>지점을 절삭한 블록으로 이동</translation>
    </message>
    <message>
        <source>Ctrl+click, or G and click, or right-click</source>
        <translation>Ctrl+클릭, G를 누르고 클릭 또는 오른쪽 클릭</translation>
    </message>
    <message>
        <source>Centre a point and orbit about it</source>
        <translation>한 지점을 중앙에 놓고 그 둘레로 회전</translation>
    </message>
    <message>
        <source>Double-click with the middle button</source>
        <translation>가운데 버튼 더블 클릭</translation>
    </message>
    <message>
        <source>Magnify a detail</source>
        <translation>상세 부분 확대</translation>
    </message>
    <message>
        <source>B and drag a box, or B and click</source>
        <translation>B를 누르고 상자를 끌거나 클릭</translation>
    </message>
</context>
<context>
    <name>Activity</name>
    <message>
        <source>Cutting</source>
        <translation>절삭</translation>
    </message>
    <message>
        <source>Air cut</source>
        <translation>공중 절삭</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>급속 이송</translation>
    </message>
    <message>
        <source>Rapid through stock</source>
        <translation>소재를 지나는 급속 이송</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Not simulated yet</source>
        <translation>아직 시뮬레이션하지 않음</translation>
    </message>
    <message>
        <source>Blocks %1 to %2, share of machine time:</source>
        <translation>블록 %1~%2, 기계 시간 비율:</translation>
    </message>
    <message>
        <source>Block %1: %2</source>
        <translation>블록 %1: %2</translation>
    </message>
    <message>
        <source>Simulated so far: cutting %1, air cut %2, rapid %3 of the time</source>
        <translation>지금까지 시뮬레이션: 절삭 %1, 공중 절삭 %2, 급속 이송 %3(시간 기준)</translation>
    </message>
</context>
<context>
    <name>AppearanceMenus</name>
    <message>
        <source>Same as &amp;System</source>
        <translation>시스템 설정(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>밝게(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>어둡게(&amp;D)</translation>
    </message>
</context>
<context>
    <name>BreakpointsPanel</name>
    <message>
        <source>Compare with &lt; &lt;= &gt; &gt;= == != and combine with &amp;&amp; || ! and parentheses. Values:</source>
        <translation>&lt; &lt;= &gt; &gt;= == !=로 비교하고 &amp;&amp; || ! 와 괄호로 조합합니다. 값:</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>조건</translation>
    </message>
    <message>
        <source>Breakpoint type</source>
        <translation>중단점 종류</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>줄</translation>
    </message>
    <message>
        <source>Stop before this line
Range: 1 to %1
Default: 1</source>
        <translation>이 줄 앞에서 멈춥니다
범위: 1 ~ %1
기본값: 1</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>높이</translation>
    </message>
    <message>
        <source>Stop before a block that moves below this height
Range: %1 to %2 mm
Default: 0 mm</source>
        <translation>이 높이보다 아래로 내려가는 블록 앞에서 멈춥니다
범위: %1 ~ %2 mm
기본값: 0 mm</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>추가</translation>
    </message>
    <message>
        <source>Add this breakpoint; to add one in the editor, click a line number</source>
        <translation>이 중단점을 추가합니다. 편집기에서는 줄 번호를 클릭하면 추가됩니다</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>제거</translation>
    </message>
    <message>
        <source>Remove the selected breakpoints</source>
        <translation>선택한 중단점을 제거합니다</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>중단점</translation>
    </message>
    <message>
        <source>Stop at</source>
        <translation>멈출 곳</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>값</translation>
    </message>
</context>
<context>
    <name>CloserLook</name>
    <message>
        <source>Drag a box on the stock, or click a point.</source>
        <translation>소재 위에서 상자를 끌어 그리거나 한 지점을 클릭하십시오.</translation>
    </message>
    <message>
        <source>At block %1: cutting…</source>
        <translation>블록 %1: 절삭하는 중…</translation>
    </message>
    <message>
        <source>At block %1: %2 × %3 points, spacing %4 mm; %5 triangles, %6 s</source>
        <translation>블록 %1: %2 × %3개의 점, 간격 %4 mm, 삼각형 %5개, %6초</translation>
    </message>
    <message>
        <source>At block %1: cancelled.</source>
        <translation>블록 %1: 취소했습니다.</translation>
    </message>
</context>
<context>
    <name>CloserLookForm</name>
    <message>
        <source>Magnifier</source>
        <translation>돋보기</translation>
    </message>
    <message>
        <source>Box:</source>
        <translation>상자:</translation>
    </message>
    <message>
        <source>Grid spacing:</source>
        <translation>격자 간격:</translation>
    </message>
    <message>
        <source>Box size in X</source>
        <translation>X 방향 상자 크기</translation>
    </message>
    <message>
        <source>Box size in Y</source>
        <translation>Y 방향 상자 크기</translation>
    </message>
    <message>
        <source>Grid spacing in the box</source>
        <translation>상자 안의 격자 간격</translation>
    </message>
    <message>
        <source>%1 From %2 to %3 mm. Default: %4 mm.</source>
        <translation>%1 %2~%3 mm. 기본값: %4 mm.</translation>
    </message>
    <message>
        <source>Size of the box in X; a click makes a box of this size.</source>
        <translation>X 방향 상자 크기입니다. 클릭하면 이 크기의 상자가 생깁니다.</translation>
    </message>
    <message>
        <source>Size of the box in Y; a click makes a box of this size.</source>
        <translation>Y 방향 상자 크기입니다. 클릭하면 이 크기의 상자가 생깁니다.</translation>
    </message>
    <message>
        <source>Distance between the grid points in the box.</source>
        <translation>상자 안 격자점 사이의 거리입니다.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Cancel this task</source>
        <translation>진행 중인 동작을 취소합니다</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>닫기(Esc)</translation>
    </message>
    <message>
        <source>Cut Again</source>
        <translation>다시 절삭</translation>
    </message>
    <message>
        <source>Cut the cancelled box again</source>
        <translation>취소한 상자를 다시 절삭합니다</translation>
    </message>
</context>
<context>
    <name>CompareDialog</name>
    <message>
        <source>in this window</source>
        <translation>이 창에</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>비교</translation>
    </message>
    <message>
        <source>Differences of %1</source>
        <translation>%1의 차이</translation>
    </message>
    <message>
        <source>Both versions of %1 have the same lines.</source>
        <translation>%1의 두 버전은 모든 줄이 같습니다.</translation>
    </message>
    <message>
        <source>− lines only on disk: %1</source>
        <translation>− 디스크에만 있는 줄: %1</translation>
    </message>
    <message>
        <source>+ lines only %1: %2</source>
        <translation>+ %1만 있는 줄: %2</translation>
    </message>
    <message>
        <source>&amp;Previous Difference</source>
        <translation>이전 차이(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Next Difference</source>
        <translation>다음 차이(&amp;N)</translation>
    </message>
    <message>
        <source>Only the first %1 lines are shown.</source>
        <translation>처음 %1줄만 표시합니다.</translation>
    </message>
</context>
<context>
    <name>ControlForm</name>
    <message>
        <source>Automatic</source>
        <translation>자동</translation>
    </message>
    <message>
        <source>Automatic: none of these</source>
        <translation>자동: 해당 없음</translation>
    </message>
    <message>
        <source>Automatic: %1</source>
        <translation>자동: %1</translation>
    </message>
</context>
<context>
    <name>ControlPanel</name>
    <message>
        <source>Control state</source>
        <translation>제어기 상태</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>의미</translation>
    </message>
    <message>
        <source>Open a program to see the modal codes, offsets and variables at the current block.</source>
        <translation>프로그램을 열면 현재 블록의 모달 코드, 옵셋, 변수를 볼 수 있습니다.</translation>
    </message>
    <message>
        <source>Calls</source>
        <translation>호출</translation>
    </message>
    <message>
        <source>from line %1</source>
        <translation>%1번 줄에서</translation>
    </message>
    <message>
        <source>Modal codes</source>
        <translation>모달 코드</translation>
    </message>
    <message>
        <source>Position and offsets (mm)</source>
        <translation>위치와 옵셋(mm)</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>변수</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>The file cannot be read: {}.</source>
        <translation>파일을 읽을 수 없습니다: {}.</translation>
    </message>
    <message>
        <source>The file cannot be written ({} needed): {}.</source>
        <translation>파일을 쓸 수 없습니다({} 필요): {}.</translation>
    </message>
    <message>
        <source>This is not a regular file.</source>
        <translation>일반 파일이 아닙니다.</translation>
    </message>
    <message>
        <source>The file has {}; the limit is {}.</source>
        <translation>파일 크기가 {}입니다. 한도는 {}입니다.</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>지름</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>코너 반경</translation>
    </message>
    <message>
        <source>Included angle</source>
        <translation>선단각</translation>
    </message>
    <message>
        <source>Diameter of the flat tip</source>
        <translation>평평한 선단의 지름</translation>
    </message>
    <message>
        <source>Flute length</source>
        <translation>날 길이</translation>
    </message>
    <message>
        <source>Shank diameter (0: as the cutter)</source>
        <translation>생크 지름(0: 공구 지름과 같음)</translation>
    </message>
    <message>
        <source>Shank length</source>
        <translation>생크 길이</translation>
    </message>
    <message>
        <source>Flat end mill</source>
        <translation>평 엔드밀</translation>
    </message>
    <message>
        <source>Ball-end mill</source>
        <translation>볼 엔드밀</translation>
    </message>
    <message>
        <source>Bull-nose mill</source>
        <translation>불노즈 엔드밀</translation>
    </message>
    <message>
        <source>Cone or V cutter</source>
        <translation>원추형 또는 V형 커터</translation>
    </message>
    <message>
        <source>Tool {} is in the table twice.</source>
        <translation>공구 {}이(가) 테이블에 두 번 있습니다.</translation>
    </message>
    <message>
        <source>Tool {} needs a cutter, e.g. cutter = &quot;ball:d=11,l=50&quot;.</source>
        <translation>공구 {}에는 커터가 필요합니다. 예: cutter = &quot;ball:d=11,l=50&quot;.</translation>
    </message>
    <message>
        <source>The file holds no [[tool]] tables.</source>
        <translation>파일에 [[tool]] 테이블이 없습니다.</translation>
    </message>
    <message>
        <source>A tool must be a table: [[tool]].</source>
        <translation>공구는 [[tool]] 테이블이어야 합니다.</translation>
    </message>
    <message>
        <source>The tool table cannot be read: {}.</source>
        <translation>공구 테이블을 읽을 수 없습니다: {}.</translation>
    </message>
    <message>
        <source>Lee &amp; Lee (local)</source>
        <translation>Lee &amp; Lee(국소)</translation>
    </message>
    <message>
        <source>Global</source>
        <translation>전역</translation>
    </message>
    <message>
        <source>None (full mesh)</source>
        <translation>없음(전체 메시)</translation>
    </message>
    <message>
        <source>Shared, no cracks</source>
        <translation>공유, 균열 없음</translation>
    </message>
    <message>
        <source>Per region, as in the paper</source>
        <translation>영역별(논문과 같음)</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>무작위</translation>
    </message>
    <message>
        <source>Sequential</source>
        <translation>순차</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>방법</translation>
    </message>
    <message>
        <source>How the mesh of a region is decimated.</source>
        <translation>영역의 메시를 간략화하는 방법입니다.</translation>
    </message>
    <message>
        <source>Region size</source>
        <translation>영역 크기</translation>
    </message>
    <message>
        <source>Cells along each side of a region; each region has its own mesh.</source>
        <translation>영역 한 변의 셀 수입니다. 영역마다 자체 메시를 가집니다.</translation>
    </message>
    <message>
        <source>Decimation period</source>
        <translation>간략화 주기</translation>
    </message>
    <message>
        <source>Cut regions are decimated again after this many blocks; -1: once at the start, 0: never.</source>
        <translation>절삭된 영역을 이 블록 수마다 다시 간략화합니다. -1: 시작할 때 한 번, 0: 하지 않음.</translation>
    </message>
    <message>
        <source>Error allowance</source>
        <translation>허용 오차</translation>
    </message>
    <message>
        <source>Largest vertical error of the decimated surface; 0: no decimation.</source>
        <translation>간략화된 곡면의 최대 수직 오차입니다. 0: 간략화하지 않음.</translation>
    </message>
    <message>
        <source>Certify</source>
        <translation>오차 보증</translation>
    </message>
    <message>
        <source>Keep every z-map point within the error allowance; off: exactly as in the paper, which gives no bound.</source>
        <translation>모든 Z맵 점을 허용 오차 안에 유지합니다. 끄면 논문 그대로이며 논문에는 오차 한계가 없습니다.</translation>
    </message>
    <message>
        <source>Borders</source>
        <translation>경계</translation>
    </message>
    <message>
        <source>How the borders between regions are simplified.</source>
        <translation>영역 사이의 경계를 단순화하는 방법입니다.</translation>
    </message>
    <message>
        <source>Removal order</source>
        <translation>제거 순서</translation>
    </message>
    <message>
        <source>The order in which vertices are tested for removal.</source>
        <translation>정점의 제거 가능 여부를 검사하는 순서입니다.</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>난수 시드</translation>
    </message>
    <message>
        <source>Start of the random order; equal seeds give equal meshes.</source>
        <translation>무작위 순서의 시작값입니다. 시드가 같으면 메시도 같습니다.</translation>
    </message>
    <message>
        <source>STL, binary</source>
        <translation>STL, 이진</translation>
    </message>
    <message>
        <source>a closed triangle mesh of the stock</source>
        <translation>소재의 닫힌 삼각형 메시</translation>
    </message>
    <message>
        <source>STL, ASCII</source>
        <translation>STL, ASCII</translation>
    </message>
    <message>
        <source>NumPy array</source>
        <translation>NumPy 배열</translation>
    </message>
    <message>
        <source>the heights of a z-map, row 0 at the smallest y</source>
        <translation>Z맵의 높이, 0행은 가장 작은 y</translation>
    </message>
    <message>
        <source>Proveout job</source>
        <translation>Proveout 작업</translation>
    </message>
    <message>
        <source>a program with its stock, tools and parameters</source>
        <translation>소재, 공구, 파라미터를 포함한 프로그램</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; is not a cutter: {}</source>
        <translation>&quot;{}&quot; 필드는 커터가 아닙니다: {}</translation>
    </message>
    <message>
        <source>This is not a Proveout job: the field &quot;proveout&quot; with the number of its format is missing.</source>
        <translation>Proveout 작업 파일이 아닙니다. 형식 번호가 있는 &quot;proveout&quot; 필드가 없습니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be the number of the format.</source>
        <translation>&quot;{}&quot; 필드는 형식 번호여야 합니다.</translation>
    </message>
    <message>
        <source>The job was written by a newer Proveout (format {}); this one reads up to format {}.</source>
        <translation>더 새로운 Proveout(형식 {})에서 만든 작업입니다. 이 버전은 형식 {}까지 읽습니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; names {}, which is outside the folder of the job; it was not read.</source>
        <translation>&quot;{}&quot; 필드가 작업 폴더 밖의 {}을(를) 가리킵니다. 이 파일은 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must name a file.</source>
        <translation>&quot;{}&quot; 필드에는 파일 이름이 있어야 합니다.</translation>
    </message>
    <message>
        <source>The name of the program is not UTF-8, which JSON needs; rename it.</source>
        <translation>프로그램 이름이 JSON에 필요한 UTF-8이 아닙니다. 이름을 바꾸십시오.</translation>
    </message>
    <message>
        <source>The brackets are nested deeper than {} levels.</source>
        <translation>괄호가 {}단계보다 깊게 중첩되어 있습니다.</translation>
    </message>
    <message>
        <source>This is not valid JSON.</source>
        <translation>올바른 JSON이 아닙니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; is missing.</source>
        <translation>&quot;{}&quot; 필드가 없습니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be a number above {} and at most {}.</source>
        <translation>&quot;{}&quot; 필드는 {}보다 크고 {} 이하인 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be a number from {} to {}.</source>
        <translation>&quot;{}&quot; 필드는 {}에서 {} 사이의 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be a text.</source>
        <translation>&quot;{}&quot; 필드는 문자열이어야 합니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be a whole number.</source>
        <translation>&quot;{}&quot; 필드는 정수여야 합니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be true or false.</source>
        <translation>&quot;{}&quot; 필드는 true 또는 false여야 합니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be three numbers [x, y, z].</source>
        <translation>&quot;{}&quot; 필드는 세 숫자 [x, y, z]여야 합니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be one of {}.</source>
        <translation>&quot;{}&quot; 필드는 다음 중 하나여야 합니다: {}.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be an object { }.</source>
        <translation>&quot;{}&quot; 필드는 객체 { }여야 합니다.</translation>
    </message>
    <message>
        <source>The NPY file holds values of type &quot;{}&quot;; little-endian float32 (&quot;&lt;f4&quot;) or float64 (&quot;&lt;f8&quot;) is needed.</source>
        <translation>NPY 파일의 값 형식이 &quot;{}&quot;입니다. 리틀 엔디언 float32(&quot;&lt;f4&quot;) 또는 float64(&quot;&lt;f8&quot;)가 필요합니다.</translation>
    </message>
    <message>
        <source>The NPY file is in Fortran order; C order is needed.</source>
        <translation>NPY 파일이 Fortran 순서입니다. C 순서가 필요합니다.</translation>
    </message>
    <message>
        <source>The NPY file has the shape {}; two dimensions (rows, columns) are needed.</source>
        <translation>NPY 파일의 형상이 {}입니다. 2차원(행, 열)이어야 합니다.</translation>
    </message>
    <message>
        <source>The header of the NPY file specifies {} values ({}), but only {} are in the file.</source>
        <translation>NPY 파일의 헤더에는 값이 {}개({})로 지정되어 있지만 파일에는 {}개만 있습니다.</translation>
    </message>
    <message>
        <source>The NPY file has the shape {}; that is too large.</source>
        <translation>NPY 파일의 형상이 {}(으)로 너무 큽니다.</translation>
    </message>
    <message>
        <source>The value in row {}, column {} (counted from 0) is {}; heights must be finite and fit float32.</source>
        <translation>{}행 {}열(0부터 셈)의 값이 {}입니다. 높이는 유한하고 float32 범위 안이어야 합니다.</translation>
    </message>
    <message>
        <source>The header of the NPY file cannot be read at byte {}.</source>
        <translation>NPY 파일의 헤더를 {}바이트 위치에서 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>This is not an NPY file.</source>
        <translation>NPY 파일이 아닙니다.</translation>
    </message>
    <message>
        <source>The NPY file has format version {}; versions 1 to 3 are known.</source>
        <translation>NPY 파일의 형식 버전이 {}입니다. 지원하는 버전은 1~3입니다.</translation>
    </message>
    <message>
        <source>The NPY file ends at byte {}, within its header of {} bytes.</source>
        <translation>NPY 파일이 {}바이트에서 끝나며 이는 {}바이트 헤더의 중간입니다.</translation>
    </message>
    <message>
        <source>Expected &quot;{}&quot; but the file ends.</source>
        <translation>&quot;{}&quot;이(가) 와야 하지만 파일이 끝납니다.</translation>
    </message>
    <message>
        <source>Expected &quot;{2}&quot; but found &quot;{1}&quot;.</source>
        <translation>&quot;{2}&quot;이(가) 와야 하지만 &quot;{1}&quot;이(가) 있습니다.</translation>
    </message>
    <message>
        <source>The file ends without &quot;endsolid&quot;; it may have been cut off.</source>
        <translation>파일이 &quot;endsolid&quot; 없이 끝납니다. 잘렸을 수 있습니다.</translation>
    </message>
    <message>
        <source>The header specifies {} facets, but the file ends at byte {}, after {}.</source>
        <translation>헤더에는 면이 {}개로 지정되어 있지만 파일이 {}바이트, {} 뒤에서 끝납니다.</translation>
    </message>
    <message>
        <source>The {} facets specified in the header were read; {} bytes follow them from byte {}.</source>
        <translation>헤더에 지정된 면 {}개를 읽었으며, {3}바이트 위치부터 {2}바이트가 더 있습니다.</translation>
    </message>
    <message>
        <source>This is not an STL file.</source>
        <translation>STL 파일이 아닙니다.</translation>
    </message>
    <message>
        <source>This is not an STL file: it ends at byte {}, within the header.</source>
        <translation>STL 파일이 아닙니다. 헤더 안인 {}바이트에서 끝납니다.</translation>
    </message>
    <message>
        <source>{} of {} facets have a coordinate that is not a finite number; they were ignored.</source>
        <translation>{2}개의 면 중 {1}개는 좌표가 유한한 수가 아니어서 무시했습니다.</translation>
    </message>
    <message>
        <source>{} of {} facets have no area; they were ignored.</source>
        <translation>{2}개의 면 중 {1}개는 면적이 없어 무시했습니다.</translation>
    </message>
    <message>
        <source>{} of {} facets have a normal against their winding; the winding counts.</source>
        <translation>{2}개의 면 중 {1}개의 법선이 정점 순서와 반대입니다. 정점 순서를 따릅니다.</translation>
    </message>
    <message>
        <source>The mesh is {} mm from the origin, where an STL file resolves steps of {} mm only.</source>
        <translation>메시가 원점에서 {} mm 떨어져 있어 STL 파일이 {} mm 단위로만 구분합니다.</translation>
    </message>
    <message>
        <source>The mesh is {} × {} × {} mm: hardly a part.</source>
        <translation>메시 크기가 {} × {} × {} mm입니다. 공작물로 보기 어렵습니다.</translation>
    </message>
    <message>
        <source>The file holds no facet that could be used ({} read, {} not finite, {} without area).</source>
        <translation>파일에 쓸 수 있는 면이 없습니다({}개 읽음, {}개 유한하지 않음, {}개 면적 없음).</translation>
    </message>
    <message>
        <source>The mesh has {} triangles; an STL file holds 4294967295.</source>
        <translation>메시의 삼각형이 {}개입니다. STL 파일에는 4294967295개까지 담을 수 있습니다.</translation>
    </message>
    <message>
        <source>Cancelled; no file was written.</source>
        <translation>취소되었습니다. 파일을 쓰지 않았습니다.</translation>
    </message>
    <message>
        <source>rapid motion</source>
        <translation>급속 이송</translation>
    </message>
    <message>
        <source>straight feed</source>
        <translation>직선 절삭 이송</translation>
    </message>
    <message>
        <source>clockwise arc</source>
        <translation>시계 방향 원호</translation>
    </message>
    <message>
        <source>counter-clockwise arc</source>
        <translation>반시계 방향 원호</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>드웰</translation>
    </message>
    <message>
        <source>cubic spline</source>
        <translation>3차 스플라인</translation>
    </message>
    <message>
        <source>quadratic spline</source>
        <translation>2차 스플라인</translation>
    </message>
    <message>
        <source>NURBS block</source>
        <translation>NURBS 블록</translation>
    </message>
    <message>
        <source>end of NURBS block</source>
        <translation>NURBS 블록 끝</translation>
    </message>
    <message>
        <source>lathe diameter mode</source>
        <translation>선반 지름 모드</translation>
    </message>
    <message>
        <source>lathe radius mode</source>
        <translation>선반 반경 모드</translation>
    </message>
    <message>
        <source>exact stop in one block</source>
        <translation>한 블록 정위치 정지</translation>
    </message>
    <message>
        <source>set offsets</source>
        <translation>옵셋 설정</translation>
    </message>
    <message>
        <source>clockwise circular pocket</source>
        <translation>시계 방향 원형 포켓</translation>
    </message>
    <message>
        <source>counter-clockwise circular pocket</source>
        <translation>반시계 방향 원형 포켓</translation>
    </message>
    <message>
        <source>polar coordinates off</source>
        <translation>극좌표 해제</translation>
    </message>
    <message>
        <source>polar coordinates on</source>
        <translation>극좌표 지정</translation>
    </message>
    <message>
        <source>XY plane</source>
        <translation>XY 평면</translation>
    </message>
    <message>
        <source>UV plane</source>
        <translation>UV 평면</translation>
    </message>
    <message>
        <source>ZX plane</source>
        <translation>ZX 평면</translation>
    </message>
    <message>
        <source>WU plane</source>
        <translation>WU 평면</translation>
    </message>
    <message>
        <source>YZ plane</source>
        <translation>YZ 평면</translation>
    </message>
    <message>
        <source>VW plane</source>
        <translation>VW 평면</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>인치</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>밀리미터</translation>
    </message>
    <message>
        <source>move to reference position</source>
        <translation>원점 복귀</translation>
    </message>
    <message>
        <source>store reference position</source>
        <translation>원점 저장</translation>
    </message>
    <message>
        <source>move to second reference position</source>
        <translation>제2 원점 복귀</translation>
    </message>
    <message>
        <source>store second reference position</source>
        <translation>제2 원점 저장</translation>
    </message>
    <message>
        <source>skip motion (probe)</source>
        <translation>스킵 이동(측정)</translation>
    </message>
    <message>
        <source>spindle-synchronised motion</source>
        <translation>주축 동기 이동</translation>
    </message>
    <message>
        <source>rigid tapping</source>
        <translation>리지드 태핑</translation>
    </message>
    <message>
        <source>probe toward the part, error on failure</source>
        <translation>공작물 쪽으로 프로빙, 실패 시 오류</translation>
    </message>
    <message>
        <source>probe toward the part</source>
        <translation>공작물 쪽으로 프로빙</translation>
    </message>
    <message>
        <source>probe away from the part, error on failure</source>
        <translation>공작물에서 멀어지며 프로빙, 실패 시 오류</translation>
    </message>
    <message>
        <source>probe away from the part</source>
        <translation>공작물에서 멀어지며 프로빙</translation>
    </message>
    <message>
        <source>cutter compensation off</source>
        <translation>공구경 보정 취소</translation>
    </message>
    <message>
        <source>cutter compensation left</source>
        <translation>공구경 보정 왼쪽</translation>
    </message>
    <message>
        <source>dynamic cutter compensation left</source>
        <translation>동적 공구경 보정 왼쪽</translation>
    </message>
    <message>
        <source>cutter compensation right</source>
        <translation>공구경 보정 오른쪽</translation>
    </message>
    <message>
        <source>dynamic cutter compensation right</source>
        <translation>동적 공구경 보정 오른쪽</translation>
    </message>
    <message>
        <source>tool length offset</source>
        <translation>공구 길이 보정</translation>
    </message>
    <message>
        <source>dynamic tool length offset</source>
        <translation>동적 공구 길이 보정</translation>
    </message>
    <message>
        <source>additional tool length offset</source>
        <translation>추가 공구 길이 보정</translation>
    </message>
    <message>
        <source>negative tool length offset</source>
        <translation>음의 공구 길이 보정</translation>
    </message>
    <message>
        <source>tool length offset off</source>
        <translation>공구 길이 보정 취소</translation>
    </message>
    <message>
        <source>scaling off</source>
        <translation>스케일링 취소</translation>
    </message>
    <message>
        <source>mirroring off</source>
        <translation>미러 취소</translation>
    </message>
    <message>
        <source>scaling</source>
        <translation>스케일링</translation>
    </message>
    <message>
        <source>mirroring</source>
        <translation>미러</translation>
    </message>
    <message>
        <source>local coordinate shift</source>
        <translation>로컬 좌표계 설정</translation>
    </message>
    <message>
        <source>machine coordinates</source>
        <translation>기계 좌표계</translation>
    </message>
    <message>
        <source>work offset 1</source>
        <translation>공작물 좌표계 1</translation>
    </message>
    <message>
        <source>additional work offset</source>
        <translation>추가 공작물 좌표계</translation>
    </message>
    <message>
        <source>work offset 2</source>
        <translation>공작물 좌표계 2</translation>
    </message>
    <message>
        <source>work offset 3</source>
        <translation>공작물 좌표계 3</translation>
    </message>
    <message>
        <source>work offset 4</source>
        <translation>공작물 좌표계 4</translation>
    </message>
    <message>
        <source>work offset 5</source>
        <translation>공작물 좌표계 5</translation>
    </message>
    <message>
        <source>work offset 6</source>
        <translation>공작물 좌표계 6</translation>
    </message>
    <message>
        <source>work offset 7</source>
        <translation>공작물 좌표계 7</translation>
    </message>
    <message>
        <source>work offset 8</source>
        <translation>공작물 좌표계 8</translation>
    </message>
    <message>
        <source>work offset 9</source>
        <translation>공작물 좌표계 9</translation>
    </message>
    <message>
        <source>exact path</source>
        <translation>정확한 경로</translation>
    </message>
    <message>
        <source>exact stop</source>
        <translation>정위치 정지</translation>
    </message>
    <message>
        <source>path blending</source>
        <translation>경로 블렌딩</translation>
    </message>
    <message>
        <source>macro call</source>
        <translation>매크로 호출</translation>
    </message>
    <message>
        <source>modal macro call</source>
        <translation>모달 매크로 호출</translation>
    </message>
    <message>
        <source>modal macro call off</source>
        <translation>모달 매크로 호출 취소</translation>
    </message>
    <message>
        <source>coordinate rotation</source>
        <translation>좌표 회전</translation>
    </message>
    <message>
        <source>coordinate rotation off</source>
        <translation>좌표 회전 취소</translation>
    </message>
    <message>
        <source>finishing cycle or bolt circle</source>
        <translation>정삭 사이클 또는 볼트 구멍 원형 배열</translation>
    </message>
    <message>
        <source>roughing cycle or bolt arc</source>
        <translation>황삭 사이클 또는 볼트 구멍 원호 배열</translation>
    </message>
    <message>
        <source>facing cycle or bolt line</source>
        <translation>단면 사이클 또는 볼트 구멍 직선 배열</translation>
    </message>
    <message>
        <source>chip-breaking drilling cycle</source>
        <translation>칩 절단 드릴링 사이클</translation>
    </message>
    <message>
        <source>left-hand tapping cycle</source>
        <translation>왼나사 태핑 사이클</translation>
    </message>
    <message>
        <source>threading or fine boring cycle</source>
        <translation>나사 절삭 또는 정밀 보링 사이클</translation>
    </message>
    <message>
        <source>motion mode off</source>
        <translation>이동 모드 취소</translation>
    </message>
    <message>
        <source>drilling cycle</source>
        <translation>드릴링 사이클</translation>
    </message>
    <message>
        <source>drilling cycle with dwell</source>
        <translation>드웰 드릴링 사이클</translation>
    </message>
    <message>
        <source>deep-hole drilling cycle</source>
        <translation>심공 드릴링 사이클</translation>
    </message>
    <message>
        <source>right-hand tapping cycle</source>
        <translation>오른나사 태핑 사이클</translation>
    </message>
    <message>
        <source>boring cycle, feed out</source>
        <translation>보링 사이클, 절삭 이송 복귀</translation>
    </message>
    <message>
        <source>boring cycle, stop and rapid out</source>
        <translation>보링 사이클, 정지 후 급속 복귀</translation>
    </message>
    <message>
        <source>back boring cycle</source>
        <translation>백 보링 사이클</translation>
    </message>
    <message>
        <source>boring cycle, manual out</source>
        <translation>보링 사이클, 수동 복귀</translation>
    </message>
    <message>
        <source>boring cycle with dwell</source>
        <translation>드웰 보링 사이클</translation>
    </message>
    <message>
        <source>absolute distances</source>
        <translation>절대 지령</translation>
    </message>
    <message>
        <source>absolute arc centres</source>
        <translation>절대 원호 중심</translation>
    </message>
    <message>
        <source>incremental distances</source>
        <translation>증분 지령</translation>
    </message>
    <message>
        <source>incremental arc centres</source>
        <translation>증분 원호 중심</translation>
    </message>
    <message>
        <source>coordinate shift</source>
        <translation>좌표계 이동</translation>
    </message>
    <message>
        <source>coordinate shift off, cleared</source>
        <translation>좌표계 이동 해제 및 삭제</translation>
    </message>
    <message>
        <source>coordinate shift off</source>
        <translation>좌표계 이동 해제</translation>
    </message>
    <message>
        <source>coordinate shift restored</source>
        <translation>좌표계 이동 복원</translation>
    </message>
    <message>
        <source>inverse time feed</source>
        <translation>역시간 이송</translation>
    </message>
    <message>
        <source>feed per minute</source>
        <translation>분당 이송</translation>
    </message>
    <message>
        <source>feed per revolution</source>
        <translation>회전당 이송</translation>
    </message>
    <message>
        <source>constant surface speed</source>
        <translation>주속 일정 제어</translation>
    </message>
    <message>
        <source>constant spindle speed</source>
        <translation>회전수 일정 제어</translation>
    </message>
    <message>
        <source>cycles retract to the initial level</source>
        <translation>사이클 후 초기점 복귀</translation>
    </message>
    <message>
        <source>cycles retract to the R plane</source>
        <translation>사이클 후 R점 복귀</translation>
    </message>
    <message>
        <source>program stop</source>
        <translation>프로그램 정지</translation>
    </message>
    <message>
        <source>optional stop</source>
        <translation>선택 정지</translation>
    </message>
    <message>
        <source>end of program</source>
        <translation>프로그램 종료</translation>
    </message>
    <message>
        <source>spindle clockwise</source>
        <translation>주축 정회전</translation>
    </message>
    <message>
        <source>spindle counter-clockwise</source>
        <translation>주축 역회전</translation>
    </message>
    <message>
        <source>spindle stop</source>
        <translation>주축 정지</translation>
    </message>
    <message>
        <source>tool change</source>
        <translation>공구 교환</translation>
    </message>
    <message>
        <source>mist coolant on</source>
        <translation>미스트 절삭유 켜기</translation>
    </message>
    <message>
        <source>flood coolant on</source>
        <translation>절삭유 켜기</translation>
    </message>
    <message>
        <source>coolant off</source>
        <translation>절삭유 끄기</translation>
    </message>
    <message>
        <source>spindle orientation</source>
        <translation>주축 정위치</translation>
    </message>
    <message>
        <source>end of program, rewind</source>
        <translation>프로그램 종료, 되감기</translation>
    </message>
    <message>
        <source>overrides on</source>
        <translation>오버라이드 유효</translation>
    </message>
    <message>
        <source>overrides off</source>
        <translation>오버라이드 무효</translation>
    </message>
    <message>
        <source>feed override</source>
        <translation>이송 오버라이드</translation>
    </message>
    <message>
        <source>spindle override</source>
        <translation>주축 오버라이드</translation>
    </message>
    <message>
        <source>adaptive feed</source>
        <translation>적응 이송</translation>
    </message>
    <message>
        <source>feed stop</source>
        <translation>이송 정지</translation>
    </message>
    <message>
        <source>pallet change</source>
        <translation>팔레트 교환</translation>
    </message>
    <message>
        <source>set the tool number</source>
        <translation>공구 번호 설정</translation>
    </message>
    <message>
        <source>digital output on, synchronised</source>
        <translation>디지털 출력 켜기, 동기</translation>
    </message>
    <message>
        <source>digital output off, synchronised</source>
        <translation>디지털 출력 끄기, 동기</translation>
    </message>
    <message>
        <source>digital output on</source>
        <translation>디지털 출력 켜기</translation>
    </message>
    <message>
        <source>digital output off</source>
        <translation>디지털 출력 끄기</translation>
    </message>
    <message>
        <source>wait for an input</source>
        <translation>입력 대기</translation>
    </message>
    <message>
        <source>analog output, synchronised</source>
        <translation>아날로그 출력, 동기</translation>
    </message>
    <message>
        <source>analog output</source>
        <translation>아날로그 출력</translation>
    </message>
    <message>
        <source>save modal state</source>
        <translation>모달 상태 저장</translation>
    </message>
    <message>
        <source>discard modal state</source>
        <translation>모달 상태 폐기</translation>
    </message>
    <message>
        <source>restore modal state</source>
        <translation>모달 상태 복원</translation>
    </message>
    <message>
        <source>save modal state, restored at the end</source>
        <translation>모달 상태 저장, 끝에서 복원</translation>
    </message>
    <message>
        <source>local subprogram call</source>
        <translation>로컬 서브프로그램 호출</translation>
    </message>
    <message>
        <source>subprogram call</source>
        <translation>서브프로그램 호출</translation>
    </message>
    <message>
        <source>end of subprogram</source>
        <translation>서브프로그램 끝</translation>
    </message>
    <message>
        <source>rotary axis about X</source>
        <translation>X축 회전축</translation>
    </message>
    <message>
        <source>rotary axis about Y</source>
        <translation>Y축 회전축</translation>
    </message>
    <message>
        <source>rotary axis about Z</source>
        <translation>Z축 회전축</translation>
    </message>
    <message>
        <source>cutter compensation number</source>
        <translation>공구경 보정 번호</translation>
    </message>
    <message>
        <source>parameter of a code</source>
        <translation>코드의 파라미터</translation>
    </message>
    <message>
        <source>feed rate</source>
        <translation>이송 속도</translation>
    </message>
    <message>
        <source>tool length offset number</source>
        <translation>공구 길이 보정 번호</translation>
    </message>
    <message>
        <source>arc centre in X</source>
        <translation>X 방향 원호 중심</translation>
    </message>
    <message>
        <source>arc centre in Y</source>
        <translation>Y 방향 원호 중심</translation>
    </message>
    <message>
        <source>arc centre in Z</source>
        <translation>Z 방향 원호 중심</translation>
    </message>
    <message>
        <source>repeats</source>
        <translation>반복 횟수</translation>
    </message>
    <message>
        <source>block number</source>
        <translation>블록 번호</translation>
    </message>
    <message>
        <source>program number</source>
        <translation>프로그램 번호</translation>
    </message>
    <message>
        <source>dwell in seconds, turns of an arc, or a parameter</source>
        <translation>드웰 시간(초), 원호 회전 횟수 또는 파라미터</translation>
    </message>
    <message>
        <source>arc radius, or the R plane</source>
        <translation>원호 반경 또는 R점</translation>
    </message>
    <message>
        <source>spindle speed in revolutions per minute</source>
        <translation>분당 주축 회전수</translation>
    </message>
    <message>
        <source>tool number</source>
        <translation>공구 번호</translation>
    </message>
    <message>
        <source>second axis along X</source>
        <translation>X 방향 제2축</translation>
    </message>
    <message>
        <source>second axis along Y</source>
        <translation>Y 방향 제2축</translation>
    </message>
    <message>
        <source>second axis along Z</source>
        <translation>Z 방향 제2축</translation>
    </message>
    <message>
        <source>X coordinate</source>
        <translation>X 좌표</translation>
    </message>
    <message>
        <source>Y coordinate</source>
        <translation>Y 좌표</translation>
    </message>
    <message>
        <source>Z coordinate</source>
        <translation>Z 좌표</translation>
    </message>
    <message>
        <source>Remove the character, or put the text into a comment: ( … ).</source>
        <translation>문자를 삭제하거나 텍스트를 주석 ( … ) 안에 넣으십시오.</translation>
    </message>
    <message>
        <source>Write the value after the letter, for example X10.5.</source>
        <translation>문자 뒤에 값을 쓰십시오. 예: X10.5.</translation>
    </message>
    <message>
        <source>Controls read this differently; write one sign.</source>
        <translation>제어기마다 다르게 읽습니다. 부호를 하나만 쓰십시오.</translation>
    </message>
    <message>
        <source>Keep one point.</source>
        <translation>소수점을 하나만 남기십시오.</translation>
    </message>
    <message>
        <source>Check the number.</source>
        <translation>숫자를 확인하십시오.</translation>
    </message>
    <message>
        <source>Close it with &quot;)&quot; in the same line.</source>
        <translation>같은 줄에서 &quot;)&quot;로 닫으십시오.</translation>
    </message>
    <message>
        <source>Controls end it at different brackets; use no &quot;(&quot; within a comment.</source>
        <translation>제어기마다 끝내는 괄호가 다릅니다. 주석 안에 &quot;(&quot;를 쓰지 마십시오.</translation>
    </message>
    <message>
        <source>Keep one of them, or make two blocks.</source>
        <translation>하나만 남기거나 두 블록으로 나누십시오.</translation>
    </message>
    <message>
        <source>Make several blocks of it.</source>
        <translation>여러 블록으로 나누십시오.</translation>
    </message>
    <message>
        <source>Write it first, or put it on a line of its own.</source>
        <translation>맨 앞이나 별도의 줄에 쓰십시오.</translation>
    </message>
    <message>
        <source>Use N with digits only.</source>
        <translation>N 뒤에는 숫자만 쓰십시오.</translation>
    </message>
    <message>
        <source>Move the rest to another line.</source>
        <translation>나머지를 다른 줄로 옮기십시오.</translation>
    </message>
    <message>
        <source>LinuxCNC refuses this; write &quot;%&quot; on the first line too, or on none.</source>
        <translation>LinuxCNC는 이를 거부합니다. 첫 줄에도 &quot;%&quot;를 쓰거나 모두 삭제하십시오.</translation>
    </message>
    <message>
        <source>Controls skip what is before or after it; keep one program per file.</source>
        <translation>제어기는 그 앞이나 뒤의 내용을 건너뜁니다. 파일 하나에 프로그램 하나만 두십시오.</translation>
    </message>
    <message>
        <source>Add M30 as the last block.</source>
        <translation>마지막 블록에 M30을 추가하십시오.</translation>
    </message>
    <message>
        <source>Check that this is the right file and that it is complete.</source>
        <translation>올바른 파일인지, 온전한지 확인하십시오.</translation>
    </message>
    <message>
        <source>Harmless here; save the file as plain text to remove them.</source>
        <translation>여기서는 문제가 없습니다. 없애려면 일반 텍스트로 저장하십시오.</translation>
    </message>
    <message>
        <source>Save it as UTF-8 without the mark, or as ASCII.</source>
        <translation>BOM 없는 UTF-8 또는 ASCII로 저장하십시오.</translation>
    </message>
    <message>
        <source>Save the file with LF or CR LF line ends.</source>
        <translation>LF 또는 CR LF 줄 끝으로 파일을 저장하십시오.</translation>
    </message>
    <message>
        <source>Split the line.</source>
        <translation>줄을 나누십시오.</translation>
    </message>
    <message>
        <source>It is a label only; renumber the blocks.</source>
        <translation>레이블일 뿐입니다. 블록 번호를 다시 매기십시오.</translation>
    </message>
    <message>
        <source>Raise the limit, or split the program.</source>
        <translation>한도를 늘리거나 프로그램을 나누십시오.</translation>
    </message>
    <message>
        <source>Results after this block are unverified.</source>
        <translation>이 블록 뒤의 결과는 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>Keep one of them, or make two blocks; this block is skipped.</source>
        <translation>하나만 남기거나 두 블록으로 나누십시오. 이 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>Make several blocks of it; this block is skipped.</source>
        <translation>여러 블록으로 나누십시오. 이 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>The motion is shown without it.</source>
        <translation>이 축 없이 이동을 표시합니다.</translation>
    </message>
    <message>
        <source>Remove it, or add the code that it belongs to; this block is skipped.</source>
        <translation>삭제하거나 이 워드를 쓰는 코드를 추가하십시오. 이 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>Write G0, G1, G2 or G3 into the block; this block is skipped.</source>
        <translation>블록에 G0, G1, G2 또는 G3을 쓰십시오. 이 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>Controls differ here; move in a block of its own. This block is skipped.</source>
        <translation>제어기마다 동작이 다릅니다. 별도의 블록에서 이동하십시오. 이 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>Add it; the code has no effect without it.</source>
        <translation>추가하십시오. 이 워드가 없으면 코드는 효과가 없습니다.</translation>
    </message>
    <message>
        <source>The word is ignored.</source>
        <translation>이 워드는 무시됩니다.</translation>
    </message>
    <message>
        <source>LinuxCNC reads F first; switch the unit in a block before.</source>
        <translation>LinuxCNC는 F를 먼저 읽습니다. 앞 블록에서 단위를 바꾸십시오.</translation>
    </message>
    <message>
        <source>Write the T word into the block or before it.</source>
        <translation>이 블록이나 그 앞에 T 워드를 쓰십시오.</translation>
    </message>
    <message>
        <source>Give F in this block or before it; there is no default.</source>
        <translation>이 블록이나 그 앞에 F를 지정하십시오. 기본값은 없습니다.</translation>
    </message>
    <message>
        <source>Position all axes with G0 before the first cut.</source>
        <translation>첫 절삭 전에 G0으로 모든 축의 위치를 정하십시오.</translation>
    </message>
    <message>
        <source>Position the axis in G90 first.</source>
        <translation>먼저 G90으로 축의 위치를 정하십시오.</translation>
    </message>
    <message>
        <source>Give the centre with {} and {}, or the radius with R.</source>
        <translation>{}와(과) {}(으)로 중심을 지정하거나 R로 반경을 지정하십시오.</translation>
    </message>
    <message>
        <source>Add the missing word, or use G91.1.</source>
        <translation>빠진 워드를 추가하거나 G91.1을 쓰십시오.</translation>
    </message>
    <message>
        <source>Controls differ in which one they use; keep one.</source>
        <translation>제어기마다 쓰는 값이 다릅니다. 하나만 남기십시오.</translation>
    </message>
    <message>
        <source>Remove the word, or select the plane that was meant.</source>
        <translation>워드를 삭제하거나 의도한 평면을 선택하십시오.</translation>
    </message>
    <message>
        <source>The centre is at the start or end point.</source>
        <translation>중심이 시작점 또는 끝점에 있습니다.</translation>
    </message>
    <message>
        <source>Check the centre: I J K are from the start point, with G90.1 from the origin.</source>
        <translation>중심을 확인하십시오. I J K는 시작점 기준이며 G90.1에서는 원점 기준입니다.</translation>
    </message>
    <message>
        <source>Give a full circle its centre, or make two arcs of it.</source>
        <translation>완전한 원에는 중심을 지정하거나 두 원호로 나누십시오.</translation>
    </message>
    <message>
        <source>Check R and the end point.</source>
        <translation>R과 끝점을 확인하십시오.</translation>
    </message>
    <message>
        <source>Check the centre; use G1 for a straight line.</source>
        <translation>중심을 확인하십시오. 직선에는 G1을 쓰십시오.</translation>
    </message>
    <message>
        <source>Check the P word.</source>
        <translation>P 워드를 확인하십시오.</translation>
    </message>
    <message>
        <source>Save it as plain text (ASCII or UTF-8) and open it again.</source>
        <translation>일반 텍스트(ASCII 또는 UTF-8)로 저장한 뒤 다시 여십시오.</translation>
    </message>
    <message>
        <source>Choose the text file that the machine would run.</source>
        <translation>기계에서 실행할 텍스트 파일을 선택하십시오.</translation>
    </message>
    <message>
        <source>Rapid move cuts stock ({} mm deep).</source>
        <translation>급속 이송이 소재를 절삭합니다(깊이 {} mm).</translation>
    </message>
    <message>
        <source>Retract above the stock before the rapid, or cut with G1.</source>
        <translation>급속 이송 전에 소재 위로 후퇴하거나 G1로 절삭하십시오.</translation>
    </message>
    <message>
        <source>The cut is {} mm deep, beyond the length of the flutes.</source>
        <translation>절삭 깊이가 {} mm로 날 길이를 넘습니다.</translation>
    </message>
    <message>
        <source>Cut in shallower passes, or choose a tool with longer flutes.</source>
        <translation>절삭 깊이를 줄이거나 날이 더 긴 공구를 선택하십시오.</translation>
    </message>
    <message>
        <source>{} more findings of the simulation are not shown.</source>
        <translation>시뮬레이션 결과 {}건을 더 표시하지 않습니다.</translation>
    </message>
    <message>
        <source>The parameter &quot;{}&quot; is {}; it must be in {} … {}.</source>
        <translation>파라미터 &quot;{}&quot;이(가) {}입니다. {} … {} 범위여야 합니다.</translation>
    </message>
    <message>
        <source>There is not enough memory for the simulation.</source>
        <translation>시뮬레이션에 필요한 메모리가 부족합니다.</translation>
    </message>
    <message>
        <source>The simulation failed: {}.</source>
        <translation>시뮬레이션에 실패했습니다: {}.</translation>
    </message>
    <message>
        <source>There is no stock left to export.</source>
        <translation>내보낼 소재가 남아 있지 않습니다.</translation>
    </message>
    <message>
        <source>The export failed: {}.</source>
        <translation>내보내기에 실패했습니다: {}.</translation>
    </message>
    <message>
        <source>There is no stock to export yet.</source>
        <translation>아직 내보낼 소재가 없습니다.</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>셀</translation>
    </message>
    <message>
        <source>blocks</source>
        <translation>블록</translation>
    </message>
    <message>
        <source>The rapid move comes from an unknown position and ends {} mm below the top of the stock; what it cuts is unknown.</source>
        <translation>급속 이송이 알 수 없는 위치에서 시작하여 소재 윗면보다 {} mm 아래에서 끝납니다. 무엇을 절삭하는지 알 수 없습니다.</translation>
    </message>
    <message>
        <source>The file cannot be written: {}.</source>
        <translation>파일을 쓸 수 없습니다: {}.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; is not known and has no effect.</source>
        <translation>&quot;{}&quot; 필드는 알 수 없는 필드이며 적용되지 않습니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; is not known and has no effect; perhaps &quot;{}&quot; is meant.</source>
        <translation>&quot;{}&quot; 필드는 알 수 없는 필드이며 적용되지 않습니다. &quot;{}&quot; 필드를 뜻한 것일 수 있습니다.</translation>
    </message>
    <message>
        <source>Correct its name, or remove it.</source>
        <translation>이름을 고치거나 필드를 삭제하십시오.</translation>
    </message>
    <message>
        <source>“{}” is not a table of a tool file; each tool is a [[tool]].</source>
        <translation>&quot;{}&quot;은(는) 공구 파일의 테이블이 아닙니다. 각 공구는 [[tool]]입니다.</translation>
    </message>
    <message>
        <source>“{}” is not a table of a tool file; perhaps “{}” is meant.</source>
        <translation>&quot;{}&quot;은(는) 공구 파일의 테이블이 아닙니다. &quot;{}&quot;을(를) 뜻한 것일 수 있습니다.</translation>
    </message>
    <message>
        <source>“{}” is not a key of a tool; there are {}.</source>
        <translation>&quot;{}&quot;은(는) 공구의 키가 아닙니다. 사용할 수 있는 키: {}.</translation>
    </message>
    <message>
        <source>“{}” is not a key of a tool; perhaps “{}” is meant.</source>
        <translation>&quot;{}&quot;은(는) 공구의 키가 아닙니다. &quot;{}&quot;을(를) 뜻한 것일 수 있습니다.</translation>
    </message>
    <message>
        <source>There is not enough memory to interpret the program.</source>
        <translation>프로그램을 해석하는 데 필요한 메모리가 부족합니다.</translation>
    </message>
    <message>
        <source>Interpreting the program failed: {}.</source>
        <translation>프로그램 해석에 실패했습니다: {}.</translation>
    </message>
    <message>
        <source>A file is still being written. Wait for it, or cancel it.</source>
        <translation>파일을 아직 쓰는 중입니다. 끝날 때까지 기다리거나 취소하십시오.</translation>
    </message>
    <message>
        <source>The value of {}, “{}”, is not a number.</source>
        <translation>{}의 값 “{}”은(는) 숫자가 아닙니다.</translation>
    </message>
    <message>
        <source>{}={} is out of range, {} to {} {}.</source>
        <translation>{}={}은(는) 허용 범위({}~{} {})를 벗어납니다.</translation>
    </message>
    <message>
        <source>The key {} is specified twice.</source>
        <translation>키 {}이(가) 두 번 지정되었습니다.</translation>
    </message>
    <message>
        <source>“{}” is not a key of this cutter shape; there are {}.</source>
        <translation>“{}”은(는) 이 커터 형상의 키가 아닙니다. 사용할 수 있는 키: {}.</translation>
    </message>
    <message>
        <source>A cutter of the shape {} needs the key {} ({}, {} to {} {}).</source>
        <translation>{} 형상의 커터에는 키 {}이(가) 필요합니다({}, {}~{} {}).</translation>
    </message>
    <message>
        <source>“{}” is not a cutter shape; there are {}.</source>
        <translation>“{}”은(는) 커터 형상이 아닙니다. 사용할 수 있는 형상: {}.</translation>
    </message>
    <message>
        <source>The flute length l={} is less than the height of the cutter&apos;s profile, {} mm.</source>
        <translation>날 길이 l={}이(가) 커터 프로파일의 높이 {} mm보다 짧습니다.</translation>
    </message>
    <message>
        <source>The corner radius r={} is larger than half the diameter, {} mm.</source>
        <translation>코너 반경 r={}이(가) 지름의 절반 {} mm보다 큽니다.</translation>
    </message>
    <message>
        <source>The flat tip tip={} is not smaller than the diameter, {} mm.</source>
        <translation>평평한 선단 tip={}이(가) 지름 {} mm보다 작지 않습니다.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; has no meaning here.</source>
        <translation>&quot;{}&quot;은(는) 여기서 의미가 없습니다.</translation>
    </message>
    <message>
        <source>{} word without a value.</source>
        <translation>{} 워드에 값이 없습니다.</translation>
    </message>
    <message>
        <source>The value of {} has two signs.</source>
        <translation>{}의 값에 부호가 두 개 있습니다.</translation>
    </message>
    <message>
        <source>The value of {} has two decimal points.</source>
        <translation>{}의 값에 소수점이 두 개 있습니다.</translation>
    </message>
    <message>
        <source>The value of {} is out of range: larger than 1e12.</source>
        <translation>{}의 값이 범위를 벗어납니다(1e12 초과).</translation>
    </message>
    <message>
        <source>The comment is not closed.</source>
        <translation>주석이 닫히지 않았습니다.</translation>
    </message>
    <message>
        <source>A comment is nested in a comment.</source>
        <translation>주석 안에 주석이 중첩되어 있습니다.</translation>
    </message>
    <message>
        <source>Duplicate {} word.</source>
        <translation>{} 워드가 중복되었습니다.</translation>
    </message>
    <message>
        <source>The block has more than 24 G and M words.</source>
        <translation>블록에 G 및 M 워드가 24개를 넘습니다.</translation>
    </message>
    <message>
        <source>The N word does not begin the block.</source>
        <translation>N 워드가 블록의 처음에 있지 않습니다.</translation>
    </message>
    <message>
        <source>The block number is negative.</source>
        <translation>블록 번호가 음수입니다.</translation>
    </message>
    <message>
        <source>&quot;%&quot; marks the beginning and the end of a tape and must be alone on its line.</source>
        <translation>&quot;%&quot;는 테이프의 시작과 끝을 나타내며 별도의 줄에 있어야 합니다.</translation>
    </message>
    <message>
        <source>The program ends with &quot;%&quot; but does not begin with it.</source>
        <translation>프로그램이 &quot;%&quot;로 끝나지만 &quot;%&quot;로 시작하지 않습니다.</translation>
    </message>
    <message>
        <source>&quot;%&quot; is in the middle of the program.</source>
        <translation>&quot;%&quot;가 프로그램 중간에 있습니다.</translation>
    </message>
    <message>
        <source>The text after the second &quot;%&quot; is not run.</source>
        <translation>두 번째 &quot;%&quot; 뒤의 텍스트는 실행되지 않습니다.</translation>
    </message>
    <message>
        <source>The blocks after the program end are not run.</source>
        <translation>프로그램 종료 뒤의 블록은 실행되지 않습니다.</translation>
    </message>
    <message>
        <source>The program has no end: M2, M30 or a pair of &quot;%&quot;.</source>
        <translation>프로그램에 종료(M2, M30 또는 &quot;%&quot; 쌍)가 없습니다.</translation>
    </message>
    <message>
        <source>The program has no motion.</source>
        <translation>프로그램에 이동이 없습니다.</translation>
    </message>
    <message>
        <source>Control codes of a tape or a serial line were skipped.</source>
        <translation>테이프 또는 시리얼 통신의 제어 문자를 건너뛰었습니다.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark, which controls reject.</source>
        <translation>파일이 제어기가 거부하는 바이트 순서 표시(BOM)로 시작합니다.</translation>
    </message>
    <message>
        <source>The line ends with CR alone, which LinuxCNC does not accept as a line end.</source>
        <translation>줄이 CR만으로 끝나며 LinuxCNC는 이를 줄 끝으로 인정하지 않습니다.</translation>
    </message>
    <message>
        <source>The line has {} characters; LinuxCNC refuses more than 252.</source>
        <translation>줄이 {}자입니다. LinuxCNC는 252자를 넘으면 거부합니다.</translation>
    </message>
    <message>
        <source>The block number has more than 15 digits, which controls cannot hold.</source>
        <translation>블록 번호가 15자리를 넘어 제어기의 한도를 벗어납니다.</translation>
    </message>
    <message>
        <source>The program has more than {} motions; interpretation ends here.</source>
        <translation>프로그램의 이동이 {}개를 넘어 여기서 해석을 끝냅니다.</translation>
    </message>
    <message>
        <source>{} more messages are not shown.</source>
        <translation>메시지 {}건을 더 표시하지 않습니다.</translation>
    </message>
    <message>
        <source>{} is not a known code.</source>
        <translation>{}은(는) 알 수 없는 코드입니다.</translation>
    </message>
    <message>
        <source>{} ({}) is not supported yet.</source>
        <translation>{}({})은(는) 아직 지원하지 않습니다.</translation>
    </message>
    <message>
        <source>{} and {} cannot be used in one block.</source>
        <translation>한 블록에서 {}와(과) {}을(를) 함께 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>{} axis ignored (three-axis machine).</source>
        <translation>{} 축을 무시합니다(3축 기계).</translation>
    </message>
    <message>
        <source>No code of this block uses the word {}.</source>
        <translation>이 블록에는 {} 워드를 쓰는 코드가 없습니다.</translation>
    </message>
    <message>
        <source>No motion code is active for the word {}.</source>
        <translation>{} 워드에 대해 유효한 이동 코드가 없습니다.</translation>
    </message>
    <message>
        <source>G80 cannot move the axis {}.</source>
        <translation>G80으로는 {} 축을 움직일 수 없습니다.</translation>
    </message>
    <message>
        <source>{} needs the word {}.</source>
        <translation>{}에는 {} 워드가 필요합니다.</translation>
    </message>
    <message>
        <source>The value of {} must not be negative.</source>
        <translation>{}의 값은 음수일 수 없습니다.</translation>
    </message>
    <message>
        <source>The value of {} must be a whole number from {} to {}.</source>
        <translation>{}의 값은 {}에서 {} 사이의 정수여야 합니다.</translation>
    </message>
    <message>
        <source>The feed is read in the unit that was in force before {}.</source>
        <translation>이송 속도는 {} 이전에 유효하던 단위로 읽습니다.</translation>
    </message>
    <message>
        <source>M6 changes the tool, but none is selected.</source>
        <translation>M6으로 공구를 교환하지만 선택된 공구가 없습니다.</translation>
    </message>
    <message>
        <source>A cutting motion has no feed rate.</source>
        <translation>절삭 이송에 이송 속도가 지정되지 않았습니다.</translation>
    </message>
    <message>
        <source>{} position unknown; move not simulated.</source>
        <translation>{}의 위치를 알 수 없어 이 이동은 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>{} moves by an incremental distance from an unknown position.</source>
        <translation>{}이(가) 알 수 없는 위치에서 증분 이동합니다.</translation>
    </message>
    <message>
        <source>The arc has neither a centre nor a radius.</source>
        <translation>원호에 중심도 반경도 없습니다.</translation>
    </message>
    <message>
        <source>An absolute centre (G90.1) needs both {} and {}.</source>
        <translation>절대 중심(G90.1)에는 {}와(과) {}이(가) 모두 필요합니다.</translation>
    </message>
    <message>
        <source>The arc has both a centre and a radius.</source>
        <translation>원호에 중심과 반경이 모두 있습니다.</translation>
    </message>
    <message>
        <source>The word {} does not belong to an arc in the plane of {}.</source>
        <translation>{} 워드는 {} 평면의 원호에 속하지 않습니다.</translation>
    </message>
    <message>
        <source>The arc has no radius: {} mm.</source>
        <translation>원호에 반경이 없습니다: {} mm.</translation>
    </message>
    <message>
        <source>The arc does not fit: radius {} mm at its start, {} mm at its end, {} mm apart.</source>
        <translation>원호가 맞지 않습니다: 시작 반경 {} mm, 끝 반경 {} mm, 차이 {} mm.</translation>
    </message>
    <message>
        <source>An arc with R cannot end where it begins.</source>
        <translation>R을 쓰는 원호는 시작점에서 끝날 수 없습니다.</translation>
    </message>
    <message>
        <source>The radius {} mm is too small: the end is {} mm from the start, {} mm more than 2 R.</source>
        <translation>반경 {} mm가 너무 작습니다: 끝점이 시작점에서 {} mm 떨어져 2 R보다 {} mm 깁니다.</translation>
    </message>
    <message>
        <source>The radius of the arc is {} mm, beyond what can be computed exactly.</source>
        <translation>원호의 반경이 {} mm로 정확히 계산할 수 있는 범위를 넘습니다.</translation>
    </message>
    <message>
        <source>P must be a whole number of turns from 1 to {}.</source>
        <translation>P는 1에서 {} 사이의 정수(회전 횟수)여야 합니다.</translation>
    </message>
    <message>
        <source>The file is encoded in {}, not in ASCII or UTF-8.</source>
        <translation>파일의 인코딩이 ASCII나 UTF-8이 아니라 {}입니다.</translation>
    </message>
    <message>
        <source>This is not an NC program: it holds binary data.</source>
        <translation>NC 프로그램이 아닙니다. 이진 데이터가 들어 있습니다.</translation>
    </message>
    <message>
        <source>The grid spacing {} mm is not a number above 0.</source>
        <translation>격자 간격 {} mm는 0보다 큰 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>Each side of the stock {} must be above 0 and at most {} mm.</source>
        <translation>소재 {}의 각 변은 0보다 크고 {} mm 이하여야 합니다.</translation>
    </message>
    <message>
        <source>The stock {} is too narrow: its sides in X and Y may differ by a factor of {} at most.</source>
        <translation>소재 {}이(가) 너무 좁습니다. X와 Y 방향 변의 길이는 최대 {}배까지만 차이가 날 수 있습니다.</translation>
    </message>
    <message>
        <source>The origin of the stock is not three numbers from -{} to {} mm.</source>
        <translation>소재 원점이 -{}에서 {} mm 사이의 숫자 세 개가 아닙니다.</translation>
    </message>
    <message>
        <source>The box {} has no area: each side must go from the smaller coordinate to the larger one.</source>
        <translation>영역 {}에 면적이 없습니다. 각 변은 작은 좌표에서 큰 좌표로 가야 합니다.</translation>
    </message>
    <message>
        <source>The box {} is not within the stock, {}.</source>
        <translation>영역 {}이(가) 소재 {} 안에 있지 않습니다.</translation>
    </message>
    <message>
        <source>A detail region of {} × {} points needs {}; {} is available, enough for a spacing of {} mm.</source>
        <translation>{} × {}점의 상세 영역에는 {}이(가) 필요하지만 사용할 수 있는 메모리는 {}입니다. 이 메모리로는 격자 간격 {} mm까지 가능합니다.</translation>
    </message>
    <message>
        <source>The grid spacing {} mm is too coarse for the stock {}; the coarsest possible is {} mm.</source>
        <translation>격자 간격 {} mm는 소재 {}에 너무 큽니다. 가능한 가장 큰 간격은 {} mm입니다.</translation>
    </message>
    <message>
        <source>The grid spacing {} mm makes {} points on the stock {}, {} of memory; the finest possible is {} mm.</source>
        <translation>격자 간격 {} mm로는 점 {}개(소재 {}, 메모리 {})가 됩니다. 가능한 가장 작은 간격은 {} mm입니다.</translation>
    </message>
    <message>
        <source>The grid spacing {} mm is lost in the rounding of coordinates as large as {} mm.</source>
        <translation>격자 간격 {} mm는 {} mm만큼 큰 좌표의 반올림에서 사라집니다.</translation>
    </message>
    <message>
        <source>“{}” is not a stock size of the form WxDxH in mm, as in {}.</source>
        <translation>“{}”은(는) {}처럼 WxDxH 형식의 소재 크기(mm)가 아닙니다.</translation>
    </message>
    <message>
        <source>Every side of the stock must be more than 0 mm, not “{}”.</source>
        <translation>소재의 모든 변은 0 mm보다 커야 하며 “{}”일 수 없습니다.</translation>
    </message>
    <message>
        <source>“{}” is not a point of the form X,Y,Z in mm.</source>
        <translation>“{}”은(는) X,Y,Z 형식의 점(mm)이 아닙니다.</translation>
    </message>
    <message>
        <source>The motion ends more than {} mm from machine zero, along {}.</source>
        <translation>이동이 기계 원점에서 {} mm보다 먼 곳에서 끝납니다({} 방향).</translation>
    </message>
    <message>
        <source>Check the values, the scaling and the repeats.</source>
        <translation>값, 스케일링, 반복 횟수를 확인하십시오.</translation>
    </message>
    <message>
        <source>The path of the arc is {} mm long, beyond the limit of {} mm; it cuts nothing.</source>
        <translation>원호 경로의 길이가 {} mm로 한계 {} mm를 넘습니다. 이 원호는 아무것도 절삭하지 않습니다.</translation>
    </message>
    <message>
        <source>Check the centre and the number of turns.</source>
        <translation>중심과 회전 횟수를 확인하십시오.</translation>
    </message>
    <message>
        <source>Point angle</source>
        <translation>선단각</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>드릴</translation>
    </message>
    <message>
        <source>The program never positions {}, so what it cuts is unknown.</source>
        <translation>프로그램이 {}의 위치를 한 번도 지정하지 않으므로 무엇을 절삭하는지 알 수 없습니다.</translation>
    </message>
    <message>
        <source>The rapid move passes over the stock at an unknown height; whether it cuts is unknown.</source>
        <translation>급속 이송이 알 수 없는 높이로 소재 위를 지나갑니다. 절삭하는지 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Position Z above the stock before the rapid.</source>
        <translation>급속 이송 전에 Z를 소재 위로 이동하십시오.</translation>
    </message>
    <message>
        <source>This is a folder, not a file.</source>
        <translation>파일이 아니라 폴더입니다.</translation>
    </message>
    <message>
        <source>The export needs {} of memory; only {} is available, enough for a grid spacing of {} mm.</source>
        <translation>내보내기에는 {}이(가) 필요하지만 사용할 수 있는 메모리는 {}입니다. 이 메모리로는 격자 간격 {} mm까지 가능합니다.</translation>
    </message>
    <message>
        <source>The export needs {} of memory; only {} is available.</source>
        <translation>내보내기에는 {}이(가) 필요하지만 사용할 수 있는 메모리는 {}입니다.</translation>
    </message>
    <message>
        <source>Wavefront OBJ</source>
        <translation>Wavefront OBJ</translation>
    </message>
    <message>
        <source>PLY, binary</source>
        <translation>PLY, 이진</translation>
    </message>
    <message>
        <source>3MF</source>
        <translation>3MF</translation>
    </message>
    <message>
        <source>The extension of this name is not that of a mesh format; there are {}.</source>
        <translation>이 이름의 확장자는 메시 형식의 것이 아닙니다. 사용할 수 있는 확장자: {}.</translation>
    </message>
    <message>
        <source>The vertex {}, {}, {} is not finite: a mesh file holds finite numbers only.</source>
        <translation>정점 {}, {}, {}이(가) 유한하지 않습니다. 메시 파일에는 유한한 수만 담을 수 있습니다.</translation>
    </message>
    <message>
        <source>Certified</source>
        <translation>오차 보증 방식</translation>
    </message>
    <message>
        <source>At every z-map point</source>
        <translation>모든 Z맵 점에서</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>모든 곳에서</translation>
    </message>
    <message>
        <source>Error level</source>
        <translation>오차 수준</translation>
    </message>
    <message>
        <source>Where the certified method keeps its surface within the error allowance, at rest and in exports; while cutting, it is at every z-map point.</source>
        <translation>오차 보증 방식이 정지 상태와 내보내기에서 표면을 허용 오차 안에 유지하는 범위입니다. 절삭 중에는 모든 Z맵 점에서 유지합니다.</translation>
    </message>
    <message>
        <source>ε = 0 (no decimation)</source>
        <translation>ε = 0 (간략화 없음)</translation>
    </message>
    <message>
        <source>with certificate</source>
        <translation>오차 보증</translation>
    </message>
    <message>
        <source>as in the paper</source>
        <translation>논문 그대로</translation>
    </message>
    <message>
        <source>regions {} × {}</source>
        <translation>영역 {} × {}</translation>
    </message>
    <message>
        <source>No decimation</source>
        <translation>간략화 없음</translation>
    </message>
    <message>
        <source>Global, after each block</source>
        <translation>전역, 블록마다</translation>
    </message>
    <message>
        <source>Local, s = {}</source>
        <translation>국소, s = {}</translation>
    </message>
    <message>
        <source>averages over {} steps</source>
        <translation>{}단계 평균</translation>
    </message>
    <message>
        <source>Step (block)</source>
        <translation>단계(블록)</translation>
    </message>
    <message>
        <source>Region size, cells</source>
        <translation>영역 크기, 셀</translation>
    </message>
    <message>
        <source>Decimation time, s</source>
        <translation>간략화 시간, s</translation>
    </message>
    <message>
        <source>Triangles shown in all frames</source>
        <translation>모든 프레임에 표시된 삼각형 수</translation>
    </message>
    <message>
        <source>Time, random</source>
        <translation>시간, 무작위</translation>
    </message>
    <message>
        <source>Time, sequential</source>
        <translation>시간, 순차</translation>
    </message>
    <message>
        <source>Triangles, random</source>
        <translation>삼각형, 무작위</translation>
    </message>
    <message>
        <source>Triangles, sequential</source>
        <translation>삼각형, 순차</translation>
    </message>
    <message>
        <source>Error allowance ε, mm</source>
        <translation>허용 오차 ε, mm</translation>
    </message>
    <message>
        <source>Ratio to ε = 0</source>
        <translation>ε = 0에 대한 비율</translation>
    </message>
    <message>
        <source>Number of triangles</source>
        <translation>삼각형 수</translation>
    </message>
    <message>
        <source>each step</source>
        <translation>각 단계</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>직선</translation>
    </message>
    <message>
        <source>Decimation period s, blocks</source>
        <translation>간략화 주기 s, 블록</translation>
    </message>
    <message>
        <source>Time, s = -1</source>
        <translation>시간, s = -1</translation>
    </message>
    <message>
        <source>Time, no decimation</source>
        <translation>시간, 간략화 없음</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>방법</translation>
    </message>
    <message>
        <source>Global and local decimation: rendering time of each frame</source>
        <translation>전역 및 국소 간략화: 프레임별 렌더링 시간</translation>
    </message>
    <message>
        <source>Decimation time and triangles by the order of removal</source>
        <translation>제거 순서에 따른 간략화 시간과 삼각형 수</translation>
    </message>
    <message>
        <source>Rendering time and region size</source>
        <translation>렌더링 시간과 영역 크기</translation>
    </message>
    <message>
        <source>Triangles and rendering time against no decimation</source>
        <translation>간략화하지 않은 경우 대비 삼각형 수와 렌더링 시간</translation>
    </message>
    <message>
        <source>Number of triangles of each frame</source>
        <translation>프레임별 삼각형 수</translation>
    </message>
    <message>
        <source>Rendering time of each frame, averages over 20 steps</source>
        <translation>프레임별 렌더링 시간, 20단계 평균</translation>
    </message>
    <message>
        <source>Number of triangles and rendering time by the decimation period</source>
        <translation>간략화 주기에 따른 삼각형 수와 렌더링 시간</translation>
    </message>
    <message>
        <source>Predicted cost by region size and period</source>
        <translation>영역 크기와 주기에 따른 예측 비용</translation>
    </message>
    <message>
        <source>Cost of the program, s</source>
        <translation>프로그램 비용, s</translation>
    </message>
    <message>
        <source>The study was stopped.</source>
        <translation>연구가 중지되었습니다.</translation>
    </message>
    <message>
        <source>Only a method that decimates region by region, with an allowance above 0, has a region size and a period to choose.</source>
        <translation>영역별로 간략화하고 허용 오차가 0보다 큰 방법에서만 영역 크기와 주기를 고를 수 있습니다.</translation>
    </message>
    <message>
        <source>There is not enough memory for the study.</source>
        <translation>연구에 필요한 메모리가 부족합니다.</translation>
    </message>
    <message>
        <source>The study failed: {}.</source>
        <translation>연구에 실패했습니다: {}.</translation>
    </message>
    <message>
        <source>OpenGL 3.3 is not available.</source>
        <translation>OpenGL 3.3을 사용할 수 없습니다.</translation>
    </message>
    <message>
        <source>The motions of the program need more than {} of memory; interpretation ends here.</source>
        <translation>프로그램의 이동에 {}이(가) 넘는 메모리가 필요하여 여기서 해석을 끝냅니다.</translation>
    </message>
    <message>
        <source>Close other programs, or split the program.</source>
        <translation>다른 프로그램을 닫거나 NC 프로그램을 나누십시오.</translation>
    </message>
    <message>
        <source>The program has more than {} tool changes, stops, dwells and the like; interpretation ends here.</source>
        <translation>프로그램의 공구 교환, 정지, 드웰 등이 {}개를 넘어 여기서 해석을 끝냅니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; names a tool that is in the table already.</source>
        <translation>필드 &quot;{}&quot;이(가) 가리키는 공구는 이미 테이블에 있습니다.</translation>
    </message>
    <message>
        <source>The method “{}” works on maps of {} points at most; this one has {}.</source>
        <translation>“{}” 방법은 최대 {}점의 Z맵에서 동작합니다. 이 Z맵은 {}점입니다.</translation>
    </message>
    <message>
        <source>The z-map needs {}; {} is available.</source>
        <translation>Z맵에 {}이(가) 필요하지만 사용할 수 있는 메모리는 {}입니다.</translation>
    </message>
    <message>
        <source>A grid of {} × {} points needs {}; {} is available, enough for a spacing of {} mm.</source>
        <translation>{} × {}점의 격자에는 {}이(가) 필요하지만 사용할 수 있는 메모리는 {}입니다. 이 메모리로는 격자 간격 {} mm까지 가능합니다.</translation>
    </message>
    <message>
        <source>Increase the grid spacing, or close other programs.</source>
        <translation>격자 간격을 크게 하거나 다른 프로그램을 닫으십시오.</translation>
    </message>
    <message>
        <source>polar radius</source>
        <translation>극좌표 반경</translation>
    </message>
    <message>
        <source>polar angle in degrees</source>
        <translation>극좌표 각도(도)</translation>
    </message>
    <message>
        <source>The expression is nested deeper than 100 levels.</source>
        <translation>수식이 100단계보다 깊게 중첩되어 있습니다.</translation>
    </message>
    <message>
        <source>Compute it in several steps.</source>
        <translation>여러 단계로 나누어 계산하십시오.</translation>
    </message>
    <message>
        <source>The parameter {} was never set.</source>
        <translation>파라미터 {}의 값이 설정된 적이 없습니다.</translation>
    </message>
    <message>
        <source>Set it first; a name without _ at its front is known in its own subprogram only.</source>
        <translation>먼저 값을 설정하십시오. 앞에 _가 없는 이름은 해당 서브프로그램 안에서만 유효합니다.</translation>
    </message>
    <message>
        <source>{} is not a whole number, so it is not a parameter number.</source>
        <translation>{}은(는) 정수가 아니므로 파라미터 번호가 아닙니다.</translation>
    </message>
    <message>
        <source>Round it with FIX or ROUND.</source>
        <translation>FIX 또는 ROUND로 정수로 만드십시오.</translation>
    </message>
    <message>
        <source>Use another number, or a name.</source>
        <translation>다른 번호나 이름을 쓰십시오.</translation>
    </message>
    <message>
        <source>The parameter {} can be read only.</source>
        <translation>파라미터 {}은(는) 읽기 전용입니다.</translation>
    </message>
    <message>
        <source>Use another number.</source>
        <translation>다른 번호를 쓰십시오.</translation>
    </message>
    <message>
        <source>The name is not closed.</source>
        <translation>이름이 닫히지 않았습니다.</translation>
    </message>
    <message>
        <source>Close it with &quot;&gt;&quot;.</source>
        <translation>&quot;&gt;&quot;로 닫으십시오.</translation>
    </message>
    <message>
        <source>The name is empty.</source>
        <translation>이름이 비어 있습니다.</translation>
    </message>
    <message>
        <source>Write a name between &quot;&lt;&quot; and &quot;&gt;&quot;.</source>
        <translation>&quot;&lt;&quot;와 &quot;&gt;&quot; 사이에 이름을 쓰십시오.</translation>
    </message>
    <message>
        <source>The name has more than 256 characters.</source>
        <translation>이름이 256자를 넘습니다.</translation>
    </message>
    <message>
        <source>Use a shorter one.</source>
        <translation>더 짧은 이름을 쓰십시오.</translation>
    </message>
    <message>
        <source>The program has more than 100000 named parameters at once; {} was not set.</source>
        <translation>이름 있는 파라미터가 동시에 100000개를 넘어 {}을(를) 설정하지 않았습니다.</translation>
    </message>
    <message>
        <source>Use fewer names, or numbers.</source>
        <translation>이름을 줄이거나 번호를 쓰십시오.</translation>
    </message>
    <message>
        <source>The bracket is not closed.</source>
        <translation>대괄호가 닫히지 않았습니다.</translation>
    </message>
    <message>
        <source>Close it with &quot;]&quot; in the same line.</source>
        <translation>같은 줄에서 &quot;]&quot;로 닫으십시오.</translation>
    </message>
    <message>
        <source>{} has no argument in brackets.</source>
        <translation>{}에 대괄호로 묶은 인수가 없습니다.</translation>
    </message>
    <message>
        <source>Write for example SIN[30].</source>
        <translation>예를 들어 SIN[30]처럼 쓰십시오.</translation>
    </message>
    <message>
        <source>Expected an operator or &quot;]&quot; but found &quot;{}&quot;.</source>
        <translation>연산자나 &quot;]&quot;이(가) 와야 하지만 &quot;{}&quot;이(가) 있습니다.</translation>
    </message>
    <message>
        <source>Check the expression.</source>
        <translation>수식을 확인하십시오.</translation>
    </message>
    <message>
        <source>{} has no result for these values.</source>
        <translation>이 값들로는 {}을(를) 계산할 수 없습니다.</translation>
    </message>
    <message>
        <source>Check for a division by zero, the root of a negative number, an arc sine beyond 1.</source>
        <translation>0으로 나누기, 음수의 제곱근, 1을 넘는 값의 아크사인이 있는지 확인하십시오.</translation>
    </message>
    <message>
        <source>EXISTS asks for a named parameter: EXISTS[#&lt;name&gt;].</source>
        <translation>EXISTS에는 이름 있는 파라미터가 필요합니다: EXISTS[#&lt;이름&gt;].</translation>
    </message>
    <message>
        <source>Write the name between &quot;&lt;&quot; and &quot;&gt;&quot;.</source>
        <translation>이름을 &quot;&lt;&quot;와 &quot;&gt;&quot; 사이에 쓰십시오.</translation>
    </message>
    <message>
        <source>{} is not followed by &quot;=&quot; and a value.</source>
        <translation>{} 뒤에 &quot;=&quot;와 값이 없습니다.</translation>
    </message>
    <message>
        <source>A parameter at the beginning of a word is an assignment, for example #1=10.</source>
        <translation>워드 맨 앞의 파라미터는 대입입니다. 예: #1=10.</translation>
    </message>
    <message>
        <source>The number after O is not a whole number from 0 up.</source>
        <translation>O 뒤의 숫자가 0 이상의 정수가 아닙니다.</translation>
    </message>
    <message>
        <source>Use a whole number, or a name: O&lt;name&gt;.</source>
        <translation>정수나 이름을 쓰십시오: O&lt;이름&gt;.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not an O-word keyword.</source>
        <translation>&quot;{}&quot;은(는) O 워드 키워드가 아닙니다.</translation>
    </message>
    <message>
        <source>Use sub, endsub, call, return, if, elseif, else, endif, do, while, endwhile, repeat, endrepeat, break or continue.</source>
        <translation>sub, endsub, call, return, if, elseif, else, endif, do, while, endwhile, repeat, endrepeat, break, continue 중 하나를 쓰십시오.</translation>
    </message>
    <message>
        <source>The O word does not begin the block.</source>
        <translation>O 워드가 블록의 처음에 있지 않습니다.</translation>
    </message>
    <message>
        <source>Put it on a line of its own.</source>
        <translation>별도의 줄에 두십시오.</translation>
    </message>
    <message>
        <source>Unexpected &quot;{}&quot; after the O word and its arguments.</source>
        <translation>O 워드와 그 인수 뒤에 잘못된 &quot;{}&quot;이(가) 있습니다.</translation>
    </message>
    <message>
        <source>O{} {} has no matching {}.</source>
        <translation>O{} {}에 짝이 되는 {}이(가) 없습니다.</translation>
    </message>
    <message>
        <source>Both need the same label, in the same subprogram.</source>
        <translation>둘 다 같은 서브프로그램 안에서 같은 레이블을 써야 합니다.</translation>
    </message>
    <message>
        <source>The label O{} is used already in line {} of this subprogram or main program.</source>
        <translation>레이블 O{}은(는) 이 서브프로그램 또는 메인 프로그램의 {}번 줄에서 이미 쓰였습니다.</translation>
    </message>
    <message>
        <source>Give each branch and each loop a label of its own.</source>
        <translation>분기와 루프마다 서로 다른 레이블을 쓰십시오.</translation>
    </message>
    <message>
        <source>After continue in a do loop, LinuxCNC may run a repeat loop twice as often as it says.</source>
        <translation>do 루프 안의 continue 다음에, LinuxCNC는 repeat 루프를 지정된 횟수의 두 배로 실행할 수 있습니다.</translation>
    </message>
    <message>
        <source>Skip the rest of the pass with if and endif instead of continue.</source>
        <translation>continue 대신 if와 endif로 회차의 나머지를 건너뛰십시오.</translation>
    </message>
    <message>
        <source>M98 with L0 runs nothing, but LinuxCNC then loses the named parameters of this program and refuses the next subprogram.</source>
        <translation>L0인 M98은 아무것도 실행하지 않지만, 그 뒤 LinuxCNC는 이 프로그램의 이름 있는 파라미터를 잃고 다음 서브프로그램을 거부합니다.</translation>
    </message>
    <message>
        <source>Leave out the call.</source>
        <translation>호출을 삭제하십시오.</translation>
    </message>
    <message>
        <source>O{} sub is inside another subprogram.</source>
        <translation>O{} sub이(가) 다른 서브프로그램 안에 있습니다.</translation>
    </message>
    <message>
        <source>Close the other one with endsub before it.</source>
        <translation>그 앞에서 다른 서브프로그램을 endsub로 끝내십시오.</translation>
    </message>
    <message>
        <source>{} needs a condition in brackets.</source>
        <translation>{}에는 대괄호로 묶은 조건이 필요합니다.</translation>
    </message>
    <message>
        <source>Write for example: O1 if [#1 GT 0].</source>
        <translation>예를 들어 다음과 같이 쓰십시오: O1 if [#1 GT 0].</translation>
    </message>
    <message>
        <source>There is no subprogram {}, in this file or as {}.</source>
        <translation>서브프로그램 {}이(가) 이 파일에도 없고 {} 파일로도 없습니다.</translation>
    </message>
    <message>
        <source>Check the name and the folders of subprograms.</source>
        <translation>이름과 서브프로그램 폴더를 확인하십시오.</translation>
    </message>
    <message>
        <source>The subprogram {} is not opened: its name leads outside the subprogram folders.</source>
        <translation>서브프로그램 {}을(를) 열지 않습니다. 이름이 서브프로그램 폴더 밖을 가리킵니다.</translation>
    </message>
    <message>
        <source>Use a name without &quot;/&quot; and &quot;..&quot;.</source>
        <translation>&quot;/&quot;와 &quot;..&quot;이 없는 이름을 쓰십시오.</translation>
    </message>
    <message>
        <source>The subprogram {} cannot be read: {}</source>
        <translation>서브프로그램 {}을(를) 읽을 수 없습니다: {}</translation>
    </message>
    <message>
        <source>Check the file.</source>
        <translation>파일을 확인하십시오.</translation>
    </message>
    <message>
        <source>The file ends within the subprogram {}.</source>
        <translation>파일이 서브프로그램 {} 안에서 끝납니다.</translation>
    </message>
    <message>
        <source>Close it with endsub or M99.</source>
        <translation>endsub 또는 M99로 끝내십시오.</translation>
    </message>
    <message>
        <source>Subprograms call each other deeper than {} levels: {}.</source>
        <translation>서브프로그램 호출이 {}단계보다 깊습니다: {}.</translation>
    </message>
    <message>
        <source>Check for a subprogram that calls itself endlessly.</source>
        <translation>자신을 끝없이 호출하는 서브프로그램이 있는지 확인하십시오.</translation>
    </message>
    <message>
        <source>The call has more than 30 arguments.</source>
        <translation>호출의 인수가 30개를 넘습니다.</translation>
    </message>
    <message>
        <source>Pass the others in global parameters.</source>
        <translation>나머지는 전역 파라미터로 넘기십시오.</translation>
    </message>
    <message>
        <source>{} is outside a subprogram.</source>
        <translation>{}이(가) 서브프로그램 밖에 있습니다.</translation>
    </message>
    <message>
        <source>Remove it, or put it between sub and endsub.</source>
        <translation>삭제하거나 sub와 endsub 사이에 두십시오.</translation>
    </message>
    <message>
        <source>M99 ends the main program: the control restarts it, endlessly.</source>
        <translation>M99가 메인 프로그램을 끝냅니다. 제어기는 메인 프로그램을 끝없이 다시 시작합니다.</translation>
    </message>
    <message>
        <source>It is run once here; use M30 if the program should end.</source>
        <translation>여기서는 한 번만 실행합니다. 프로그램을 끝내려면 M30을 쓰십시오.</translation>
    </message>
    <message>
        <source>{} does not begin its block; LinuxCNC looks for it there only.</source>
        <translation>{}이(가) 블록의 처음에 있지 않습니다. LinuxCNC는 블록의 처음에서만 찾습니다.</translation>
    </message>
    <message>
        <source>Put it first in the block.</source>
        <translation>블록의 맨 앞에 쓰십시오.</translation>
    </message>
    <message>
        <source>M99 is not alone in its block; LinuxCNC stops there with an error.</source>
        <translation>M99가 블록에 단독으로 있지 않습니다. LinuxCNC는 여기서 오류로 멈춥니다.</translation>
    </message>
    <message>
        <source>The repeated lines and their motions exceed {}; interpretation ends in line {}.</source>
        <translation>반복된 줄과 그 이동이 모두 {}개를 넘어 {}번 줄에서 해석을 끝냅니다.</translation>
    </message>
    <message>
        <source>Check loops and repeat counts. The motions of this repetition are not shown.</source>
        <translation>루프와 반복 횟수를 확인하십시오. 이 반복의 이동은 표시하지 않습니다.</translation>
    </message>
    <message>
        <source>More than {} repeated lines in a row make no motion; interpretation ends in line {}.</source>
        <translation>반복된 줄이 연속으로 {}개를 넘도록 이동이 없어 {}번 줄에서 해석을 끝냅니다.</translation>
    </message>
    <message>
        <source>Check the loop for an end.</source>
        <translation>루프가 끝나는지 확인하십시오.</translation>
    </message>
    <message>
        <source>This loop never ends: line {} jumps back to line {} and no variable changes from one pass to the next.</source>
        <translation>이 루프는 끝나지 않습니다. {}번 줄이 {}번 줄로 되돌아가고 회차마다 바뀌는 변수가 없습니다.</translation>
    </message>
    <message>
        <source>Check the loop condition. Only the first passes are shown.</source>
        <translation>루프의 조건을 확인하십시오. 처음 몇 회만 표시합니다.</translation>
    </message>
    <message>
        <source>{} repeats are more than the limit of {}; nothing is repeated here.</source>
        <translation>반복 {}회는 한계인 {}회를 넘으므로 여기서는 아무것도 반복하지 않습니다.</translation>
    </message>
    <message>
        <source>Check the number of repeats.</source>
        <translation>반복 횟수를 확인하십시오.</translation>
    </message>
    <message>
        <source>This block makes {} motions, more than the limit of {}; it is not executed.</source>
        <translation>이 블록은 이동을 {}개 만들어 한계인 {}개를 넘으므로 실행하지 않습니다.</translation>
    </message>
    <message>
        <source>Check the depth of the pecks, the step and the number of repeats.</source>
        <translation>1회 절입량, 간격, 반복 횟수를 확인하십시오.</translation>
    </message>
    <message>
        <source>G10 with L{} is not supported.</source>
        <translation>G10 L{}은(는) 지원하지 않습니다.</translation>
    </message>
    <message>
        <source>Supported are L1, L2, L10, L11 and L20.</source>
        <translation>L1, L2, L10, L11, L20을 지원합니다.</translation>
    </message>
    <message>
        <source>No tool has the number {}.</source>
        <translation>번호가 {}인 공구가 없습니다.</translation>
    </message>
    <message>
        <source>Add it to the tool table, or correct the number.</source>
        <translation>공구 테이블에 추가하거나 번호를 고치십시오.</translation>
    </message>
    <message>
        <source>{} and {} both use the axis words of this block.</source>
        <translation>{}와(과) {}이(가) 모두 이 블록의 축 워드를 씁니다.</translation>
    </message>
    <message>
        <source>Make two blocks; this block is skipped.</source>
        <translation>두 블록으로 나누십시오. 이 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>G53 needs G0 or G1 in force.</source>
        <translation>G53을 쓰려면 G0 또는 G1이 유효해야 합니다.</translation>
    </message>
    <message>
        <source>Write G53 G0 or G53 G1; this block is skipped.</source>
        <translation>G53 G0 또는 G53 G1을 쓰십시오. 이 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>The block has polar words (@ ^) and X or Y.</source>
        <translation>블록에 극좌표 워드(@ ^)와 X 또는 Y가 함께 있습니다.</translation>
    </message>
    <message>
        <source>Keep one kind; this block is skipped.</source>
        <translation>한 가지만 남기십시오. 이 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>{} counts from the current angle, and there is no angle at X0 Y0.</source>
        <translation>{}은(는) 현재 각도를 기준으로 하지만 X0 Y0에는 각도가 없습니다.</translation>
    </message>
    <message>
        <source>Give both @ and ^ in G90; this motion is skipped.</source>
        <translation>G90에서 @와 ^를 모두 지정하십시오. 이 이동은 건너뜁니다.</translation>
    </message>
    <message>
        <source>G53 cannot be used with polar words.</source>
        <translation>G53은 극좌표 워드와 함께 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>Write X and Y; this block is skipped.</source>
        <translation>X와 Y를 쓰십시오. 이 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>G53 cannot be used with incremental distances.</source>
        <translation>G53은 증분 지령과 함께 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>Write G90 before it; this block is skipped.</source>
        <translation>그 앞에 G90을 쓰십시오. 이 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>Machine zero is unknown, so {} has no position; motions are not simulated until the axis is positioned again.</source>
        <translation>기계 원점을 알 수 없으므로 {}의 위치가 없습니다. 그 축의 위치를 다시 정할 때까지 이동을 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>Motions to reference positions are taken to lead away from the part.</source>
        <translation>원점으로 가는 이동은 공작물에서 멀어지는 것으로 가정합니다.</translation>
    </message>
    <message>
        <source>The cycle {} needs the word {}.</source>
        <translation>{} 사이클에는 {} 워드가 필요합니다.</translation>
    </message>
    <message>
        <source>The first block of a cycle must have it; this one drills nothing.</source>
        <translation>사이클의 첫 블록에는 이 워드가 있어야 합니다. 이 블록은 아무것도 가공하지 않습니다.</translation>
    </message>
    <message>
        <source>The cycle has no axis word.</source>
        <translation>사이클에 축 워드가 없습니다.</translation>
    </message>
    <message>
        <source>Program the position of the first hole.</source>
        <translation>첫 구멍의 위치를 지령하십시오.</translation>
    </message>
    <message>
        <source>A cycle cannot be used with inverse time feed.</source>
        <translation>사이클은 역시간 이송과 함께 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>Write G94 and a feed before it; the cycle drills nothing.</source>
        <translation>그 앞에 G94와 이송 속도를 쓰십시오. 이 사이클은 아무것도 가공하지 않습니다.</translation>
    </message>
    <message>
        <source>With inverse time feed (G93) every cutting block needs an F word.</source>
        <translation>역시간 이송(G93)에서는 절삭 이송 블록마다 F 워드가 필요합니다.</translation>
    </message>
    <message>
        <source>Add F, one over the minutes that the motion takes.</source>
        <translation>이동에 걸리는 시간(분)의 역수를 F로 추가하십시오.</translation>
    </message>
    <message>
        <source>The feed counts per revolution (G95), but the spindle does not turn.</source>
        <translation>회전당 이송(G95)이지만 주축이 회전하지 않습니다.</translation>
    </message>
    <message>
        <source>Switch the spindle on, or write G94 and a feed per minute.</source>
        <translation>주축을 회전시키거나 G94와 분당 이송 속도를 쓰십시오.</translation>
    </message>
    <message>
        <source>The R plane is below the hole bottom.</source>
        <translation>R점이 구멍 바닥보다 아래에 있습니다.</translation>
    </message>
    <message>
        <source>Check R and the depth; the cycle drills nothing.</source>
        <translation>R과 깊이를 확인하십시오. 이 사이클은 아무것도 가공하지 않습니다.</translation>
    </message>
    <message>
        <source>The depth of a peck must be greater than 0.</source>
        <translation>1회 절입량은 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>Check the Q word; the cycle drills nothing.</source>
        <translation>Q 워드를 확인하십시오. 이 사이클은 아무것도 가공하지 않습니다.</translation>
    </message>
    <message>
        <source>The spindle must turn for this cycle: {}.</source>
        <translation>이 사이클에서는 주축이 회전해야 합니다: {}.</translation>
    </message>
    <message>
        <source>Switch it on in a block before; the cycle drills nothing.</source>
        <translation>앞 블록에서 주축을 회전시키십시오. 이 사이클은 아무것도 가공하지 않습니다.</translation>
    </message>
    <message>
        <source>G87 cuts from below, which a z-map cannot represent.</source>
        <translation>G87은 아래쪽에서 절삭하며, 이는 Z맵으로 나타낼 수 없습니다.</translation>
    </message>
    <message>
        <source>The motions are shown; what they cut from below is unverified.</source>
        <translation>이동은 표시하지만 아래쪽에서 절삭하는 부분은 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>The position {} cannot be read while cutter compensation is on.</source>
        <translation>공구경 보정 중에는 위치 {}을(를) 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>Write G40 before it.</source>
        <translation>그 앞에 G40을 쓰십시오.</translation>
    </message>
    <message>
        <source>Cutter compensation is on already.</source>
        <translation>공구경 보정이 이미 적용되어 있습니다.</translation>
    </message>
    <message>
        <source>Write G40 first; {} has no effect.</source>
        <translation>먼저 G40을 쓰십시오. {}은(는) 효과가 없습니다.</translation>
    </message>
    <message>
        <source>Cutter compensation works in the planes of G17 and G18 only.</source>
        <translation>공구경 보정은 G17과 G18 평면에서만 적용됩니다.</translation>
    </message>
    <message>
        <source>Select the plane before; the code has no effect.</source>
        <translation>그 앞에서 평면을 선택하십시오. 이 코드는 효과가 없습니다.</translation>
    </message>
    <message>
        <source>Cutter compensation in G18 under a rotation about Z is not supported.</source>
        <translation>Z축을 중심으로 좌표를 회전한 상태에서는 G18의 공구경 보정을 지원하지 않습니다.</translation>
    </message>
    <message>
        <source>Remove the rotation from the work offset; the code has no effect.</source>
        <translation>공작물 좌표계에서 회전을 제거하십시오. 이 코드는 효과가 없습니다.</translation>
    </message>
    <message>
        <source>{} cannot be used while cutter compensation is on.</source>
        <translation>공구경 보정 중에는 {}을(를) 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>Write G40 before it; the code has no effect.</source>
        <translation>그 앞에 G40을 쓰십시오. 이 코드는 효과가 없습니다.</translation>
    </message>
    <message>
        <source>The diameter for {} is 0, so the tool moves on the programmed path.</source>
        <translation>{}에 쓸 지름이 0이어서 공구가 프로그램된 경로를 그대로 따라갑니다.</translation>
    </message>
    <message>
        <source>Check the tool table, if the path is not written for the centre of the tool.</source>
        <translation>공구 중심 기준으로 작성한 경로가 아니라면 공구 테이블을 확인하십시오.</translation>
    </message>
    <message>
        <source>No diameter is known for {}, so the tool moves on the programmed path.</source>
        <translation>{}에 쓸 지름을 알 수 없어 공구가 프로그램된 경로를 그대로 따라갑니다.</translation>
    </message>
    <message>
        <source>Give the tools of the program.</source>
        <translation>프로그램에서 쓰는 공구를 지정하십시오.</translation>
    </message>
    <message>
        <source>The motion is not compensated: it leads from or to a place that is not known.</source>
        <translation>이 이동에는 보정을 적용하지 않습니다. 시작점이나 끝점의 위치를 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Position the axes of the plane before G41 or G42.</source>
        <translation>G41이나 G42 전에 평면의 축 위치를 정하십시오.</translation>
    </message>
    <message>
        <source>The motion into cutter compensation is {} mm long, not longer than the tool&apos;s radius of {} mm.</source>
        <translation>공구경 보정으로 진입하는 이동의 길이가 {} mm로 공구 반경 {} mm보다 길지 않습니다.</translation>
    </message>
    <message>
        <source>Begin farther away; the motion is skipped.</source>
        <translation>더 먼 곳에서 시작하십시오. 이 이동은 건너뜁니다.</translation>
    </message>
    <message>
        <source>The arc has a radius of {} mm, not larger than the tool&apos;s radius of {} mm.</source>
        <translation>원호의 반경이 {} mm로 공구 반경 {} mm보다 크지 않습니다.</translation>
    </message>
    <message>
        <source>Use a smaller tool; the motion is skipped.</source>
        <translation>더 작은 공구를 쓰십시오. 이 이동은 건너뜁니다.</translation>
    </message>
    <message>
        <source>The tool with a radius of {} mm does not fit into this inside corner.</source>
        <translation>반경 {} mm인 공구가 이 안쪽 코너에 들어가지 않습니다.</translation>
    </message>
    <message>
        <source>The tool with a radius of {} mm gouges between the inside corners of the motion of line {}.</source>
        <translation>반경 {} mm인 공구가 {}번 줄 이동의 안쪽 코너 사이에서 과절삭합니다.</translation>
    </message>
    <message>
        <source>Use a smaller tool, or remove the short motion.</source>
        <translation>더 작은 공구를 쓰거나 짧은 이동을 삭제하십시오.</translation>
    </message>
    <message>
        <source>The tool with a radius of {} mm goes backward in the motion of line {} and gouges; LinuxCNC does not notice.</source>
        <translation>반경 {} mm인 공구가 {}번 줄의 이동에서 거꾸로 움직여 과절삭합니다. LinuxCNC는 이를 알아채지 못합니다.</translation>
    </message>
    <message>
        <source>A stop before this inside corner makes the tool overrun it and gouge.</source>
        <translation>이 안쪽 코너 앞의 정지 때문에 공구가 코너를 지나쳐 과절삭합니다.</translation>
    </message>
    <message>
        <source>Stop elsewhere: the corner is known only when the motion to it is done.</source>
        <translation>다른 곳에서 정지하십시오. 코너로 가는 이동이 끝난 뒤에야 코너를 알 수 있습니다.</translation>
    </message>
    <message>
        <source>The first motion after G40 must be straight.</source>
        <translation>G40 뒤의 첫 이동은 직선이어야 합니다.</translation>
    </message>
    <message>
        <source>Lead out with G0 or G1; the arc is skipped.</source>
        <translation>G0 또는 G1로 빠져나오십시오. 이 원호는 건너뜁니다.</translation>
    </message>
    <message>
        <source>Cutter compensation is still on at the end of the program.</source>
        <translation>프로그램이 끝날 때까지 공구경 보정이 취소되지 않았습니다.</translation>
    </message>
    <message>
        <source>Lead out with G40.</source>
        <translation>G40으로 보정을 취소하며 빠져나오십시오.</translation>
    </message>
    <message>
        <source>M72 restores a modal state, but none is saved at this level of calls.</source>
        <translation>M72는 모달 상태를 복원하지만, 이 호출 단계에 저장된 상태가 없습니다.</translation>
    </message>
    <message>
        <source>Write M70 or M73 before it, in the same subprogram.</source>
        <translation>같은 서브프로그램 안에서 그 앞에 M70 또는 M73을 쓰십시오.</translation>
    </message>
    <message>
        <source>M72 is not alone in its block.</source>
        <translation>M72가 블록에 단독으로 있지 않습니다.</translation>
    </message>
    <message>
        <source>LinuxCNC ignores the rest of the block after restoring; give M72 a block of its own.</source>
        <translation>LinuxCNC는 복원한 뒤 블록의 나머지를 무시합니다. M72를 별도의 블록에 쓰십시오.</translation>
    </message>
    <message>
        <source>G7 makes X a diameter, as on a lathe: LinuxCNC would halve every X.</source>
        <translation>G7은 선반처럼 X를 지름으로 만듭니다. LinuxCNC는 모든 X를 절반으로 읽습니다.</translation>
    </message>
    <message>
        <source>Remove it, or write G8; X is shown as a radius.</source>
        <translation>삭제하거나 G8을 쓰십시오. X는 반경으로 표시됩니다.</translation>
    </message>
    <message>
        <source>With G96 the spindle follows X; it is taken to turn at its limit D, {} rpm.</source>
        <translation>G96에서는 주축이 X를 따릅니다. 한계값 D인 {} rpm으로 회전한다고 가정합니다.</translation>
    </message>
    <message>
        <source>X is not a diameter on a mill: write G97 and a speed.</source>
        <translation>밀링 머신에서 X는 지름이 아닙니다. G97과 회전수를 쓰십시오.</translation>
    </message>
    <message>
        <source>Spindle speed is unknown, because G96 has no D.</source>
        <translation>G96에 D가 없으므로 주축 회전수를 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Write G97 and a speed, or a limit D.</source>
        <translation>G97과 회전수를, 또는 한계값 D를 쓰십시오.</translation>
    </message>
    <message>
        <source>M66 has P and E: a digital and an analog input.</source>
        <translation>M66에 P와 E가 모두 있습니다: 디지털 입력과 아날로그 입력.</translation>
    </message>
    <message>
        <source>Keep one of them.</source>
        <translation>둘 중 하나만 남기십시오.</translation>
    </message>
    <message>
        <source>M66 cannot wait for an analog input.</source>
        <translation>M66은 아날로그 입력을 기다릴 수 없습니다.</translation>
    </message>
    <message>
        <source>Remove L, or write L0.</source>
        <translation>L을 삭제하거나 L0을 쓰십시오.</translation>
    </message>
    <message>
        <source>Input value of M66 unknown; #5399 is assumed to be {}.</source>
        <translation>M66의 입력값을 알 수 없습니다. #5399는 {}(으)로 가정합니다.</translation>
    </message>
    <message>
        <source>What follows is verified as long as it does not read #5399.</source>
        <translation>#5399를 읽지 않는 한 뒤의 내용은 검증됩니다.</translation>
    </message>
    <message>
        <source>This line reads #5399, which holds an input of the machine.</source>
        <translation>이 줄은 기계의 입력이 담긴 #5399를 읽습니다.</translation>
    </message>
    <message>
        <source>Results that depend on it are unverified.</source>
        <translation>이 값에 따른 결과는 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>The pitch K must be greater than 0.</source>
        <translation>피치 K는 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>Check the K word; nothing moves.</source>
        <translation>K 워드를 확인하십시오. 아무것도 움직이지 않습니다.</translation>
    </message>
    <message>
        <source>{} moves in step with the spindle and takes no F.</source>
        <translation>{}은(는) 주축에 동기하여 움직이므로 F를 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>Remove F; the feed is the pitch K times the speed of the spindle.</source>
        <translation>F를 삭제하십시오. 이송 속도는 피치 K에 주축 회전수를 곱한 값입니다.</translation>
    </message>
    <message>
        <source>{} moves in step with the spindle, which does not turn.</source>
        <translation>{}은(는) 주축에 동기하여 움직이지만 주축이 회전하지 않습니다.</translation>
    </message>
    <message>
        <source>Write S and M3 or M4 in a block before.</source>
        <translation>앞 블록에 S와 M3 또는 M4를 쓰십시오.</translation>
    </message>
    <message>
        <source>Probing with a feed per revolution (G95) is not possible.</source>
        <translation>회전당 이송(G95)으로는 프로빙할 수 없습니다.</translation>
    </message>
    <message>
        <source>Write G94 and a feed per minute.</source>
        <translation>G94와 분당 이송을 쓰십시오.</translation>
    </message>
    <message>
        <source>The probing motion ends where it begins.</source>
        <translation>프로빙 이동이 시작한 곳에서 끝납니다.</translation>
    </message>
    <message>
        <source>Check the axis words.</source>
        <translation>축 워드를 확인하십시오.</translation>
    </message>
    <message>
        <source>The position where the probe meets the part is unknown.</source>
        <translation>프로브가 공작물에 닿는 위치를 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Write G17 before it.</source>
        <translation>그 앞에 G17을 쓰십시오.</translation>
    </message>
    <message>
        <source>G5 without I and J continues a G5, but the motion before it is not a G5.</source>
        <translation>I와 J 없는 G5는 앞의 G5를 잇지만, 바로 앞 이동은 G5가 아닙니다.</translation>
    </message>
    <message>
        <source>Program I and J; LinuxCNC would use values left by an earlier block.</source>
        <translation>I와 J를 지령하십시오. 그렇지 않으면 LinuxCNC는 앞 블록이 남긴 값을 씁니다.</translation>
    </message>
    <message>
        <source>The spline needs more than {} straight motions.</source>
        <translation>이 스플라인에는 직선 이동이 {}개 넘게 필요합니다.</translation>
    </message>
    <message>
        <source>Check its points.</source>
        <translation>점들을 확인하십시오.</translation>
    </message>
    <message>
        <source>A control point needs both X and Y.</source>
        <translation>제어점에는 X와 Y가 모두 필요합니다.</translation>
    </message>
    <message>
        <source>Add the missing word; the point is ignored.</source>
        <translation>빠진 워드를 추가하십시오. 이 점은 무시됩니다.</translation>
    </message>
    <message>
        <source>A control point needs a weight P greater than 0.</source>
        <translation>제어점에는 0보다 큰 가중치 P가 필요합니다.</translation>
    </message>
    <message>
        <source>Write P1 for an ordinary point; the point is ignored.</source>
        <translation>보통 점이면 P1을 쓰십시오. 이 점은 무시됩니다.</translation>
    </message>
    <message>
        <source>P without X and Y is the weight of the first control point only.</source>
        <translation>X와 Y 없는 P는 첫 제어점의 가중치일 뿐입니다.</translation>
    </message>
    <message>
        <source>Close the NURBS block with G5.3 before the next one begins.</source>
        <translation>다음 NURBS 블록을 시작하기 전에 G5.3으로 닫으십시오.</translation>
    </message>
    <message>
        <source>The NURBS block has {} control points, fewer than its order {}.</source>
        <translation>NURBS 블록의 제어점은 {}개로, 차수 {}보다 적습니다.</translation>
    </message>
    <message>
        <source>Add points, or lower the order L.</source>
        <translation>점을 추가하거나 차수 L을 낮추십시오.</translation>
    </message>
    <message>
        <source>G5.3 closes a NURBS block, but none is open.</source>
        <translation>G5.3은 NURBS 블록을 닫지만, 열린 블록이 없습니다.</translation>
    </message>
    <message>
        <source>Start it with G5.2; other motions in between end it.</source>
        <translation>G5.2로 시작하십시오. 사이의 다른 이동은 블록을 끝냅니다.</translation>
    </message>
    <message>
        <source>A NURBS block was started by G5.2 but not closed: it makes no motion.</source>
        <translation>G5.2로 시작한 NURBS 블록이 닫히지 않아 이동이 없습니다.</translation>
    </message>
    <message>
        <source>Write G5.3 after its last control point.</source>
        <translation>마지막 제어점 뒤에 G5.3을 쓰십시오.</translation>
    </message>
    <message>
        <source>high-speed machining</source>
        <translation>고속 가공</translation>
    </message>
    <message>
        <source>look-ahead contour control</source>
        <translation>선행 윤곽 제어</translation>
    </message>
    <message>
        <source>hypothetical axis interpolation</source>
        <translation>가상축 보간</translation>
    </message>
    <message>
        <source>look-ahead control</source>
        <translation>선행 제어</translation>
    </message>
    <message>
        <source>set data</source>
        <translation>데이터 설정</translation>
    </message>
    <message>
        <source>end of set data</source>
        <translation>데이터 설정 끝</translation>
    </message>
    <message>
        <source>polar coordinate interpolation</source>
        <translation>극좌표 보간</translation>
    </message>
    <message>
        <source>polar coordinate interpolation off</source>
        <translation>극좌표 보간 취소</translation>
    </message>
    <message>
        <source>stored stroke check on</source>
        <translation>저장 스트로크 체크 켜기</translation>
    </message>
    <message>
        <source>stored stroke check off</source>
        <translation>저장 스트로크 체크 끄기</translation>
    </message>
    <message>
        <source>spindle speed watch off</source>
        <translation>주축 속도 감시 끄기</translation>
    </message>
    <message>
        <source>spindle speed watch on</source>
        <translation>주축 속도 감시 켜기</translation>
    </message>
    <message>
        <source>check of the reference position</source>
        <translation>원점 복귀 확인</translation>
    </message>
    <message>
        <source>return from reference position</source>
        <translation>원점에서 복귀</translation>
    </message>
    <message>
        <source>thread cutting</source>
        <translation>나사 절삭</translation>
    </message>
    <message>
        <source>automatic tool length measurement</source>
        <translation>자동 공구 길이 측정</translation>
    </message>
    <message>
        <source>lengthen the motion by the offset</source>
        <translation>이동량을 옵셋만큼 늘리기</translation>
    </message>
    <message>
        <source>shorten the motion by the offset</source>
        <translation>이동량을 옵셋만큼 줄이기</translation>
    </message>
    <message>
        <source>lengthen the motion by twice the offset</source>
        <translation>이동량을 옵셋의 두 배만큼 늘리기</translation>
    </message>
    <message>
        <source>shorten the motion by twice the offset</source>
        <translation>이동량을 옵셋의 두 배만큼 줄이기</translation>
    </message>
    <message>
        <source>approach from one side</source>
        <translation>한 방향 위치 결정</translation>
    </message>
    <message>
        <source>automatic corner override</source>
        <translation>자동 코너 오버라이드</translation>
    </message>
    <message>
        <source>tapping mode</source>
        <translation>태핑 모드</translation>
    </message>
    <message>
        <source>cutting mode</source>
        <translation>절삭 모드</translation>
    </message>
    <message>
        <source>macro call by every block</source>
        <translation>블록마다 매크로 호출</translation>
    </message>
    <message>
        <source>tilted working plane</source>
        <translation>경사면 가공</translation>
    </message>
    <message>
        <source>fine boring cycle</source>
        <translation>정밀 보링 사이클</translation>
    </message>
    <message>
        <source>boring cycle, stop and manual out</source>
        <translation>보링 사이클, 정지 후 수동 복귀</translation>
    </message>
    <message>
        <source>boring cycle with dwell, feed out</source>
        <translation>보링 사이클, 드웰 후 절삭 이송 복귀</translation>
    </message>
    <message>
        <source>set the work coordinates</source>
        <translation>공작물 좌표 설정</translation>
    </message>
    <message>
        <source>preset the work coordinates</source>
        <translation>공작물 좌표 초기화</translation>
    </message>
    <message>
        <source>call of a program in external memory</source>
        <translation>외부 메모리 프로그램 호출</translation>
    </message>
    <message>
        <source>There is no parameter with the number {}.</source>
        <translation>번호가 {}인 파라미터가 없습니다.</translation>
    </message>
    <message>
        <source>{} needs two arguments.</source>
        <translation>{}에는 인수가 두 개 필요합니다.</translation>
    </message>
    <message>
        <source>Write ATAN[y]/[x].</source>
        <translation>ATAN[y]/[x]와 같이 쓰십시오.</translation>
    </message>
    <message>
        <source>The jump target is not a whole number from 0 to 99999999.</source>
        <translation>점프 대상이 0부터 99999999까지의 정수가 아닙니다.</translation>
    </message>
    <message>
        <source>Jump to a block number that follows an N.</source>
        <translation>N 뒤에 있는 블록 번호로 점프하십시오.</translation>
    </message>
    <message>
        <source>There is no block N{} in this program.</source>
        <translation>이 프로그램에는 N{} 블록이 없습니다.</translation>
    </message>
    <message>
        <source>Check the number; a jump does not leave its program.</source>
        <translation>번호를 확인하십시오. 점프는 프로그램을 벗어나지 않습니다.</translation>
    </message>
    <message>
        <source>The statement is not complete.</source>
        <translation>매크로 문이 완전하지 않습니다.</translation>
    </message>
    <message>
        <source>Write IF [#1 GT 2] GOTO 10, IF [#1 GT 2] THEN #3=4, or WHILE [#1 GT 2] DO 1.</source>
        <translation>IF [#1 GT 2] GOTO 10, IF [#1 GT 2] THEN #3=4 또는 WHILE [#1 GT 2] DO 1과 같이 쓰십시오.</translation>
    </message>
    <message>
        <source>The statement does not begin the block.</source>
        <translation>매크로 문이 블록의 처음에 있지 않습니다.</translation>
    </message>
    <message>
        <source>The loop has no matching {}.</source>
        <translation>루프에 짝이 되는 {}이(가) 없습니다.</translation>
    </message>
    <message>
        <source>DO 1 needs END 1 in the same program; loops do not cross each other.</source>
        <translation>DO 1에는 같은 프로그램의 END 1이 필요하며, 루프는 서로 교차할 수 없습니다.</translation>
    </message>
    <message>
        <source>The value of {} is kept by the machine; it is assumed to be 0.</source>
        <translation>{}의 값은 기계에 저장됩니다. 0으로 가정합니다.</translation>
    </message>
    <message>
        <source>Check the program with other values where a decision depends on it.</source>
        <translation>분기가 이 값에 따라 달라지면 다른 값으로도 프로그램을 확인하십시오.</translation>
    </message>
    <message>
        <source>The value of {} depends on the machine that runs the program.</source>
        <translation>{}의 값은 프로그램을 실행하는 기계에 따라 다릅니다.</translation>
    </message>
    <message>
        <source>What follows from it is unverified.</source>
        <translation>이 값에 따른 결과는 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>The position {} is not known here.</source>
        <translation>여기에서는 위치 {}을(를) 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Position the axis first, or enter a start position in the setup.</source>
        <translation>먼저 축의 위치를 정하거나 셋업에서 시작 위치를 입력하십시오.</translation>
    </message>
    <message>
        <source>The program stops itself with alarm {}.</source>
        <translation>프로그램이 알람 {}(으)로 정지합니다.</translation>
    </message>
    <message>
        <source>The comment beside it says why; the program ends here.</source>
        <translation>이유는 옆의 주석에 있습니다. 프로그램은 여기서 끝납니다.</translation>
    </message>
    <message>
        <source>Dialect detected: {} (from {}).</source>
        <translation>감지된 제어기 방식: {}(근거: {}).</translation>
    </message>
    <message>
        <source>Choose the dialect yourself if that is wrong.</source>
        <translation>맞지 않으면 제어기 방식을 직접 선택하십시오.</translation>
    </message>
    <message>
        <source>The text before the first &quot;%&quot; is not run.</source>
        <translation>첫 번째 &quot;%&quot; 앞의 텍스트는 실행되지 않습니다.</translation>
    </message>
    <message>
        <source>{} and {} cannot be used in one block; the last one counts.</source>
        <translation>한 블록에서 {}와(과) {}을(를) 함께 쓸 수 없습니다. 마지막 코드가 적용됩니다.</translation>
    </message>
    <message>
        <source>Some controls give an alarm instead; keep one of them.</source>
        <translation>알람을 내는 제어기도 있으므로 하나만 남기십시오.</translation>
    </message>
    <message>
        <source>Duplicate {} word; the last one counts.</source>
        <translation>{} 워드가 중복되었습니다. 마지막 워드가 적용됩니다.</translation>
    </message>
    <message>
        <source>No code of this block uses the word {}; it is ignored.</source>
        <translation>이 블록에는 {} 워드를 쓰는 코드가 없으므로 무시합니다.</translation>
    </message>
    <message>
        <source>Remove it, or add the code that it belongs to.</source>
        <translation>삭제하거나 이 워드를 쓰는 코드를 추가하십시오.</translation>
    </message>
    <message>
        <source>After G80, {} moves without a motion code, at rapid.</source>
        <translation>G80 뒤에서 {} 축이 이동 코드 없이 급속 이송으로 움직입니다.</translation>
    </message>
    <message>
        <source>Write G0 or G1 into the block; controls differ here.</source>
        <translation>블록에 G0이나 G1을 쓰십시오. 제어기마다 동작이 다릅니다.</translation>
    </message>
    <message>
        <source>{} has no decimal point: the control reads it as {}; one with calculator-type input as {}.</source>
        <translation>{}에 소수점이 없습니다. 이 제어기는 {}(으)로 읽고, 계산기형 입력 방식에서는 {}(으)로 읽습니다.</translation>
    </message>
    <message>
        <source>Write the decimal point.</source>
        <translation>소수점을 쓰십시오.</translation>
    </message>
    <message>
        <source>The block has more than {} M words.</source>
        <translation>블록에 M 워드가 {}개보다 많습니다.</translation>
    </message>
    <message>
        <source>The feed rate is 0.</source>
        <translation>이송 속도가 0입니다.</translation>
    </message>
    <message>
        <source>Give F a value above 0.</source>
        <translation>F에 0보다 큰 값을 지정하십시오.</translation>
    </message>
    <message>
        <source>T{} cuts without its own tool length offset.</source>
        <translation>T{}이(가) 자체 공구 길이 보정 없이 절삭합니다.</translation>
    </message>
    <message>
        <source>Write G43 after the tool change: the offset of the previous tool is still active.</source>
        <translation>공구 교환 뒤에 G43을 쓰십시오. 이전 공구의 보정이 아직 유효합니다.</translation>
    </message>
    <message>
        <source>The program cuts before it selects a work offset.</source>
        <translation>공작물 좌표계를 선택하기 전에 절삭합니다.</translation>
    </message>
    <message>
        <source>Write G54, or the work offset of the part.</source>
        <translation>G54 또는 공작물에 맞는 공작물 좌표계를 쓰십시오.</translation>
    </message>
    <message>
        <source>The tool length offset H{} does not match tool {}.</source>
        <translation>공구 길이 보정 H{}이(가) 공구 {}와(과) 맞지 않습니다.</translation>
    </message>
    <message>
        <source>Use the tool number, unless another offset is intended.</source>
        <translation>다른 보정을 의도한 것이 아니라면 공구 번호를 쓰십시오.</translation>
    </message>
    <message>
        <source>{} has no D word.</source>
        <translation>{}에 D 워드가 없습니다.</translation>
    </message>
    <message>
        <source>Write the offset number: the last one used is active.</source>
        <translation>보정 번호를 쓰십시오. 마지막에 쓴 번호가 유효합니다.</translation>
    </message>
    <message>
        <source>Cutter compensation begins on an arc.</source>
        <translation>공구경 보정이 원호에서 시작합니다.</translation>
    </message>
    <message>
        <source>Lead in with a straight motion; many controls give an alarm here.</source>
        <translation>직선으로 진입하십시오. 여기서 알람을 내는 제어기가 많습니다.</translation>
    </message>
    <message>
        <source>{} changes the unit in the middle of the program.</source>
        <translation>{}이(가) 프로그램 중간에 단위를 바꿉니다.</translation>
    </message>
    <message>
        <source>Keep to one unit; active lengths keep the old one.</source>
        <translation>한 가지 단위만 쓰십시오. 유효한 길이 값은 이전 단위를 유지합니다.</translation>
    </message>
    <message>
        <source>Still active here: {}.</source>
        <translation>여기서 아직 유효한 코드: {}.</translation>
    </message>
    <message>
        <source>End it before the tool change and before the end of the program.</source>
        <translation>공구 교환과 프로그램 끝 전에 취소하십시오.</translation>
    </message>
    <message>
        <source>The tool is changed at Z{}, not above Z{}, where it cut.</source>
        <translation>Z{}에서 공구를 교환합니다. 절삭한 Z{}보다 높지 않습니다.</translation>
    </message>
    <message>
        <source>Retract first.</source>
        <translation>먼저 후퇴하십시오.</translation>
    </message>
    <message>
        <source>The tool is changed while the spindle turns.</source>
        <translation>주축이 회전하는 동안 공구를 교환합니다.</translation>
    </message>
    <message>
        <source>Write M5 before it; not every machine stops the spindle by itself.</source>
        <translation>그 앞에 M5를 쓰십시오. 주축을 스스로 멈추지 않는 기계도 있습니다.</translation>
    </message>
    <message>
        <source>The arc by its radius is nearly a half circle, {} degrees.</source>
        <translation>반경으로 지정한 원호가 거의 반원({}도)입니다.</translation>
    </message>
    <message>
        <source>Program the centre with I, J and K: here the last digit of R moves it far.</source>
        <translation>중심을 I, J, K로 지령하십시오. 여기서는 R의 마지막 자리 숫자만으로도 중심이 크게 움직입니다.</translation>
    </message>
    <message>
        <source>in its block only</source>
        <translation>해당 블록에서만</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>평면</translation>
    </message>
    <message>
        <source>distance mode</source>
        <translation>좌표 지령 방식</translation>
    </message>
    <message>
        <source>arc distance mode</source>
        <translation>원호 중심 지령 방식</translation>
    </message>
    <message>
        <source>feed mode</source>
        <translation>이송 방식</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>cutter compensation</source>
        <translation>공구경 보정</translation>
    </message>
    <message>
        <source>tool length</source>
        <translation>공구 길이</translation>
    </message>
    <message>
        <source>canned-cycle return</source>
        <translation>고정 사이클 복귀</translation>
    </message>
    <message>
        <source>work offset</source>
        <translation>공작물 좌표계</translation>
    </message>
    <message>
        <source>path control</source>
        <translation>경로 제어</translation>
    </message>
    <message>
        <source>spindle mode</source>
        <translation>주축 모드</translation>
    </message>
    <message>
        <source>polar coordinates</source>
        <translation>극좌표</translation>
    </message>
    <message>
        <source>look-ahead</source>
        <translation>선행 제어</translation>
    </message>
    <message>
        <source>diameter mode</source>
        <translation>지름 모드</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>정지</translation>
    </message>
    <message>
        <source>inputs and outputs</source>
        <translation>입출력</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>주축</translation>
    </message>
    <message>
        <source>coolant</source>
        <translation>절삭유</translation>
    </message>
    <message>
        <source>overrides</source>
        <translation>오버라이드</translation>
    </message>
    <message>
        <source>saved modal state</source>
        <translation>저장된 모달 상태</translation>
    </message>
    <message>
        <source>subprogram</source>
        <translation>서브프로그램</translation>
    </message>
    <message>
        <source>tapping</source>
        <translation>태핑</translation>
    </message>
    <message>
        <source>Repeated lines gave {} messages; interpretation ends here.</source>
        <translation>반복된 줄에서 메시지가 {}개 나와 여기서 해석을 끝냅니다.</translation>
    </message>
    <message>
        <source>Correct what is wrong in the loop.</source>
        <translation>루프의 오류를 고치십시오.</translation>
    </message>
    <message>
        <source>engraving of text</source>
        <translation>문자 각인</translation>
    </message>
    <message>
        <source>bolt hole circle</source>
        <translation>볼트 구멍 원형 배열</translation>
    </message>
    <message>
        <source>bolt hole arc</source>
        <translation>볼트 구멍 원호 배열</translation>
    </message>
    <message>
        <source>bolt holes along a line</source>
        <translation>볼트 구멍 직선 배열</translation>
    </message>
    <message>
        <source>boring cycle, dwell, stop and manual out</source>
        <translation>보링 사이클, 드웰과 정지 후 수동 복귀</translation>
    </message>
    <message>
        <source>limit of the look-ahead</source>
        <translation>선독 블록 수 제한</translation>
    </message>
    <message>
        <source>cylindrical mapping</source>
        <translation>원통 보간 매핑</translation>
    </message>
    <message>
        <source>pocket of any shape</source>
        <translation>임의 형상 포켓</translation>
    </message>
    <message>
        <source>smoothness of the path</source>
        <translation>경로 평활도</translation>
    </message>
    <message>
        <source>The boring bar moves aside before it leaves the bore, but is cut as a full cylinder.</source>
        <translation>보링 바는 구멍에서 나오기 전에 옆으로 이동하지만, 시뮬레이션에서는 완전한 원통으로 절삭합니다.</translation>
    </message>
    <message>
        <source>Contacts shown during the retract are unverified.</source>
        <translation>후퇴 중에 표시되는 접촉은 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>The operator retracts the tool from the hole by hand.</source>
        <translation>작업자가 수동으로 공구를 구멍에서 후퇴시킵니다.</translation>
    </message>
    <message>
        <source>A straight retract is shown; results after this block are unverified.</source>
        <translation>직선 후퇴로 표시합니다. 이 블록 뒤의 결과는 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>Back boring feeds up from R, but the depth is not above R.</source>
        <translation>백 보링은 R점에서 위로 절삭 이송하지만 깊이가 R점보다 위에 있지 않습니다.</translation>
    </message>
    <message>
        <source>Check R and the depth; the cycle bores nothing.</source>
        <translation>R과 깊이를 확인하십시오. 이 사이클은 아무것도 가공하지 않습니다.</translation>
    </message>
    <message>
        <source>{} cannot be used with G99; it returns to the initial level.</source>
        <translation>{}은(는) G99와 함께 쓸 수 없으며 초기점으로 복귀합니다.</translation>
    </message>
    <message>
        <source>Write G98 before it.</source>
        <translation>그 앞에 G98을 쓰십시오.</translation>
    </message>
    <message>
        <source>G98 returns to the initial level, which is unknown; a return to R is shown.</source>
        <translation>G98은 초기점으로 복귀하지만 초기점을 알 수 없어 R점 복귀로 표시합니다.</translation>
    </message>
    <message>
        <source>Position the axis before the cycle.</source>
        <translation>사이클 전에 축의 위치를 정하십시오.</translation>
    </message>
    <message>
        <source>{} has no Q: the hole is drilled in one go.</source>
        <translation>{}에 Q가 없어 구멍을 한 번에 가공합니다.</translation>
    </message>
    <message>
        <source>Newer controls stop with an alarm instead; give the depth of a peck.</source>
        <translation>최신 제어기는 알람으로 정지합니다. 1회 절입량을 지정하십시오.</translation>
    </message>
    <message>
        <source>The spindle is stopped and M29 (rigid tapping) is not active.</source>
        <translation>주축이 정지해 있고 M29(리지드 태핑)가 유효하지 않습니다.</translation>
    </message>
    <message>
        <source>Some machines tap rigidly without M29, as shown here; write M29 before the cycle.</source>
        <translation>여기 표시된 것처럼 M29 없이 리지드 태핑을 하는 기계도 있습니다. 사이클 앞에 M29를 쓰십시오.</translation>
    </message>
    <message>
        <source>With 0 repeats the cycle is only stored; the {} of this block is not moved to.</source>
        <translation>반복 횟수가 0이면 사이클을 기억하기만 하며, 이 블록의 {}(으)로는 이동하지 않습니다.</translation>
    </message>
    <message>
        <source>Some controls move there; program the position in another block.</source>
        <translation>그 위치로 이동하는 제어기도 있습니다. 위치는 다른 블록에 지령하십시오.</translation>
    </message>
    <message>
        <source>{} drills with the active canned cycle, but no cycle is active.</source>
        <translation>{}은(는) 유효한 고정 사이클로 가공하지만, 유효한 사이클이 없습니다.</translation>
    </message>
    <message>
        <source>Write the cycle with L0 in a block before; the pattern drills nothing.</source>
        <translation>앞 블록에 L0으로 사이클을 쓰십시오. 이 패턴은 아무것도 가공하지 않습니다.</translation>
    </message>
    <message>
        <source>The first hole of G72 is assumed to be at the current position.</source>
        <translation>G72의 첫 구멍은 현재 위치에 있다고 가정합니다.</translation>
    </message>
    <message>
        <source>Check it against the manual of the control.</source>
        <translation>제어기 설명서에서 확인하십시오.</translation>
    </message>
    <message>
        <source>How the control moves from circle to circle of the pocket is not documented; half circles are shown.</source>
        <translation>포켓의 원에서 원으로 이동하는 방법은 문서에 없습니다. 반원으로 표시합니다.</translation>
    </message>
    <message>
        <source>The finished pocket is the same.</source>
        <translation>완성된 포켓은 같습니다.</translation>
    </message>
    <message>
        <source>No pocket leads from radius {} mm to {} mm with a tool of radius {} mm.</source>
        <translation>반경 {} mm부터 {} mm까지의 포켓은 반경 {} mm인 공구로 가공할 수 없습니다.</translation>
    </message>
    <message>
        <source>Check I, K and D; the pocket is not milled.</source>
        <translation>I, K, D를 확인하십시오. 이 포켓은 가공하지 않습니다.</translation>
    </message>
    <message>
        <source>G29 returns through the intermediate point of G28, which is unknown for {}.</source>
        <translation>G29는 G28의 중간점을 거쳐 복귀하지만, {}의 중간점을 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Position the axis before G28 and program it there.</source>
        <translation>G28 전에 축의 위치를 정하고 G28에 그 축을 지령하십시오.</translation>
    </message>
    <message>
        <source>G60 overshoots by a distance set in the machine; it is shown without the overshoot.</source>
        <translation>G60은 기계에 설정된 거리만큼 지나쳤다가 돌아오지만, 여기서는 그 동작 없이 표시합니다.</translation>
    </message>
    <message>
        <source>Make sure that there is room beyond the target.</source>
        <translation>목표 위치 너머에 여유 공간이 있는지 확인하십시오.</translation>
    </message>
    <message>
        <source>The skip motion is shown to its end; where a signal stops it is unknown.</source>
        <translation>스킵 이동은 끝까지 표시합니다. 신호로 정지하는 위치는 알 수 없습니다.</translation>
    </message>
    <message>
        <source>The arc has both a centre and a radius; the radius counts.</source>
        <translation>원호에 중심과 반경이 모두 있습니다. 반경이 적용됩니다.</translation>
    </message>
    <message>
        <source>Other controls refuse this; keep one.</source>
        <translation>다른 제어기는 이를 거부하므로 하나만 남기십시오.</translation>
    </message>
    <message>
        <source>The arc with R ends where it begins, so that nothing moves.</source>
        <translation>R을 쓴 원호의 끝점이 시작점과 같아 아무것도 움직이지 않습니다.</translation>
    </message>
    <message>
        <source>The arc has neither a centre nor a radius: the control moves straight, or stops with an alarm.</source>
        <translation>원호에 중심도 반경도 없습니다. 제어기는 직선으로 이동하거나 알람으로 정지합니다.</translation>
    </message>
    <message>
        <source>Give the centre with I, J or K, or the radius with R.</source>
        <translation>I, J, K로 중심을 지정하거나 R로 반경을 지정하십시오.</translation>
    </message>
    <message>
        <source>Program position</source>
        <translation>프로그램 위치</translation>
    </message>
    <message>
        <source>Work offset</source>
        <translation>공작물 좌표계</translation>
    </message>
    <message>
        <source>Shift by G52 and G92</source>
        <translation>G52와 G92의 좌표계 이동</translation>
    </message>
    <message>
        <source>Tool length offset</source>
        <translation>공구 길이 보정</translation>
    </message>
    <message>
        <source>Feed rate</source>
        <translation>이송 속도</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>주축 회전수</translation>
    </message>
    <message>
        <source>Tool in the spindle</source>
        <translation>주축의 공구</translation>
    </message>
    <message>
        <source>Next tool</source>
        <translation>다음 공구</translation>
    </message>
    <message>
        <source>G68 rotates in another plane than that of the arc, which then is in no plane of the machine.</source>
        <translation>G68이 원호의 평면이 아닌 다른 평면을 회전하므로 원호가 기계의 어느 평면에도 놓이지 않습니다.</translation>
    </message>
    <message>
        <source>Keep the plane that was active at G68.</source>
        <translation>G68에서 유효했던 평면을 유지하십시오.</translation>
    </message>
    <message>
        <source>Different scale factors along the axes of its plane turn this arc into an ellipse.</source>
        <translation>평면의 두 축에 서로 다른 스케일링 배율이 적용되어 이 원호가 타원이 됩니다.</translation>
    </message>
    <message>
        <source>Use one factor for both axes, or let the CAM system output lines.</source>
        <translation>두 축에 같은 배율을 쓰거나 CAM 시스템에서 직선으로 출력하십시오.</translation>
    </message>
    <message>
        <source>The scale factor of {} must not be 0.</source>
        <translation>{}의 스케일링 배율은 0일 수 없습니다.</translation>
    </message>
    <message>
        <source>Check the number; the code has no effect.</source>
        <translation>숫자를 확인하십시오. 이 코드는 효과가 없습니다.</translation>
    </message>
    <message>
        <source>{} is inside {}: the control needs mirror image, scaling and rotation started in this order and cancelled in the opposite one.</source>
        <translation>{}이(가) {} 안에 있습니다. 제어기에서는 미러, 스케일링, 회전을 이 순서로 시작하고 반대 순서로 취소해야 합니다.</translation>
    </message>
    <message>
        <source>Cancel the inner one first.</source>
        <translation>안쪽 지령을 먼저 취소하십시오.</translation>
    </message>
    <message>
        <source>The first motion after {} does not program both axes of the rotation; controls differ here.</source>
        <translation>{} 뒤의 첫 이동이 회전의 두 축을 모두 지령하지 않습니다. 제어기마다 동작이 다릅니다.</translation>
    </message>
    <message>
        <source>Position both axes in G90 after it.</source>
        <translation>그 뒤에 G90으로 두 축의 위치를 모두 지령하십시오.</translation>
    </message>
    <message>
        <source>G53 is ignored with incremental distances; nothing moves.</source>
        <translation>증분 지령에서는 G53이 무시되어 아무것도 움직이지 않습니다.</translation>
    </message>
    <message>
        <source>Write G90 before it.</source>
        <translation>그 앞에 G90을 쓰십시오.</translation>
    </message>
    <message>
        <source>Supported are L1, L2, L10 to L13 and L20.</source>
        <translation>L1, L2, L10~L13, L20을 지원합니다.</translation>
    </message>
    <message>
        <source>G10 with L{} begins to set data of the control; the blocks up to G11 are skipped.</source>
        <translation>G10 L{}은(는) 제어기 데이터 입력을 시작합니다. G11까지의 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>What depends on these data is unverified.</source>
        <translation>이 데이터에 따른 결과는 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>The offset register {} is not known.</source>
        <translation>보정 번호 {}의 값을 알 수 없습니다.</translation>
    </message>
    <message>
        <source>The tool with its number fills it, or G10; add the tool, or correct the number.</source>
        <translation>같은 번호의 공구나 G10이 이 값을 정합니다. 공구를 추가하거나 번호를 고치십시오.</translation>
    </message>
    <message>
        <source>{} changes the tool length without a Z word; some machines move by the difference, others do not.</source>
        <translation>{}이(가) Z 워드 없이 공구 길이를 바꿉니다. 차이만큼 이동하는 기계도 있고 이동하지 않는 기계도 있습니다.</translation>
    </message>
    <message>
        <source>Position Z in the same block; here Z does not move.</source>
        <translation>같은 블록에서 Z의 위치를 지령하십시오. 여기서는 Z가 이동하지 않습니다.</translation>
    </message>
    <message>
        <source>{} suspends cutter compensation on its way.</source>
        <translation>{}은(는) 이동하는 동안 공구경 보정을 일시 취소합니다.</translation>
    </message>
    <message>
        <source>Cutter compensation cannot begin on an arc (alarm 034).</source>
        <translation>공구경 보정은 원호에서 시작할 수 없습니다(알람 034).</translation>
    </message>
    <message>
        <source>Lead in with G0 or G1; the arc is skipped.</source>
        <translation>G0 또는 G1로 진입하십시오. 원호는 건너뜁니다.</translation>
    </message>
    <message>
        <source>The corner before this motion is not compensated: the tool stops square to the end of the block before it, and continues from there.</source>
        <translation>이 이동 앞의 코너는 보정되지 않습니다. 공구는 앞 블록의 끝점에서 직각인 위치에 멈춘 뒤 거기서 계속 이동합니다.</translation>
    </message>
    <message>
        <source>Keep stops, repeated codes and blocks without a motion away from corners.</source>
        <translation>정지, 반복된 코드, 이동이 없는 블록을 코너에 두지 마십시오.</translation>
    </message>
    <message>
        <source>The tool changes side between paths that do not meet.</source>
        <translation>공구가 서로 만나지 않는 경로 사이에서 보정 방향을 바꿉니다.</translation>
    </message>
    <message>
        <source>Write G40 before the other side.</source>
        <translation>보정 방향을 바꾸기 전에 G40을 쓰십시오.</translation>
    </message>
    <message>
        <source>The tool with a radius of {} mm goes backward in the motion of line {}; the control leaves out points of the corner before it, or stops (alarm 041).</source>
        <translation>반경 {} mm인 공구가 {}번 줄의 이동에서 거꾸로 움직입니다. 제어기는 그 앞 코너의 점을 생략하거나 정지합니다(알람 041).</translation>
    </message>
    <message>
        <source>The compensated arc begins {} mm off its circle.</source>
        <translation>보정된 원호가 자기 원에서 {} mm 벗어난 곳에서 시작합니다.</translation>
    </message>
    <message>
        <source>Change side, radius or code of compensation before a straight motion.</source>
        <translation>보정의 방향, 반경, 코드는 직선 이동 앞에서 바꾸십시오.</translation>
    </message>
    <message>
        <source>Interpretation was stopped before this line; the last one was {}.</source>
        <translation>이 줄 앞에서 해석이 중단되었습니다. 마지막 줄은 {}입니다.</translation>
    </message>
    <message>
        <source>The program is still being read; the lines from here on are missing.</source>
        <translation>프로그램을 아직 읽는 중입니다. 여기부터의 줄은 아직 없습니다.</translation>
    </message>
    <message>
        <source>The control reports error:20 (unsupported command) and skips the block; remove it.</source>
        <translation>제어기가 error:20(지원하지 않는 명령)으로 응답하고 블록을 건너뜁니다. 해당 코드를 삭제하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:1 (letter expected) and skips the block; remove the character.</source>
        <translation>제어기가 error:1(문자가 와야 함)으로 응답하고 블록을 건너뜁니다. 그 글자를 삭제하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:2 (bad number) and skips the block; write the number.</source>
        <translation>제어기가 error:2(잘못된 숫자)로 응답하고 블록을 건너뜁니다. 숫자를 쓰십시오.</translation>
    </message>
    <message>
        <source>The control reports error:2 (bad number) and skips the block; write one sign.</source>
        <translation>제어기가 error:2(잘못된 숫자)로 응답하고 블록을 건너뜁니다. 부호를 하나만 쓰십시오.</translation>
    </message>
    <message>
        <source>The control reports error:2 (bad number) and skips the block; keep one point.</source>
        <translation>제어기가 error:2(잘못된 숫자)로 응답하고 블록을 건너뜁니다. 소수점을 하나만 남기십시오.</translation>
    </message>
    <message>
        <source>The control reports error:1 or error:2 and skips the block; let the CAM system write plain numbers.</source>
        <translation>제어기가 error:1 또는 error:2로 응답하고 블록을 건너뜁니다. CAM 시스템에서 일반 숫자로 출력하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:4 (negative value) and skips the block; correct the number.</source>
        <translation>제어기가 error:4(음수 값)으로 응답하고 블록을 건너뜁니다. 숫자를 고치십시오.</translation>
    </message>
    <message>
        <source>The control reports error:21 (two codes of one group) and skips the block; make two blocks.</source>
        <translation>제어기가 error:21(한 그룹의 코드가 둘)로 응답하고 블록을 건너뜁니다. 두 블록으로 나누십시오.</translation>
    </message>
    <message>
        <source>The control reports error:22 (no feed rate) and skips the block, its motion code too; give F.</source>
        <translation>제어기가 error:22(이송 속도 없음)으로 응답하고 이동 코드까지 포함해 블록을 건너뜁니다. F를 지정하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:20 or error:23 and skips the block; remove the code.</source>
        <translation>제어기가 error:20 또는 error:23으로 응답하고 블록을 건너뜁니다. 코드를 삭제하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:24 (two codes use the axis words) and skips the block; make two blocks.</source>
        <translation>제어기가 error:24(두 코드가 축 워드를 사용)으로 응답하고 블록을 건너뜁니다. 두 블록으로 나누십시오.</translation>
    </message>
    <message>
        <source>The control reports error:25 (repeated word) and skips the block; make two blocks.</source>
        <translation>제어기가 error:25(중복된 워드)로 응답하고 블록을 건너뜁니다. 두 블록으로 나누십시오.</translation>
    </message>
    <message>
        <source>The control reports error:26 (no axis words) or error:28 (a word is missing) and skips the block; add the word.</source>
        <translation>제어기가 error:26(축 워드 없음) 또는 error:28(워드 누락)으로 응답하고 블록을 건너뜁니다. 워드를 추가하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:29 to P of G10, error:38 to T, and skips the block; correct the number.</source>
        <translation>제어기가 G10의 P에는 error:29, T에는 error:38로 응답하고 블록을 건너뜁니다. 숫자를 고치십시오.</translation>
    </message>
    <message>
        <source>The control reports error:30 (G53 needs G0 or G1) and skips the block; write G53 G0 or G53 G1.</source>
        <translation>제어기가 error:30(G53에는 G0 또는 G1이 필요)로 응답하고 블록을 건너뜁니다. G53 G0 또는 G53 G1을 쓰십시오.</translation>
    </message>
    <message>
        <source>The control reports error:31 (axis words without a motion) and skips the block; write G0 or G1.</source>
        <translation>제어기가 error:31(이동 없는 축 워드)로 응답하고 블록을 건너뜁니다. G0 또는 G1을 쓰십시오.</translation>
    </message>
    <message>
        <source>The control reports error:26 or error:32 and skips the block; write the end point, also of a full circle.</source>
        <translation>제어기가 error:26 또는 error:32로 응답하고 블록을 건너뜁니다. 완전한 원에도 끝점을 쓰십시오.</translation>
    </message>
    <message>
        <source>The control reports error:33 (invalid target): the radii may differ by 0.005 mm, and by 0.1 % up to 0.5 mm; check the centre.</source>
        <translation>제어기가 error:33(잘못된 목표)로 응답합니다. 반경은 0.005 mm까지, 그리고 0.5 mm 이내에서 0.1 %까지 다를 수 있습니다. 중심을 확인하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:33 (invalid target) and skips the block; give a full circle its centre.</source>
        <translation>제어기가 error:33(잘못된 목표)로 응답하고 블록을 건너뜁니다. 완전한 원에는 중심을 지정하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:33 (invalid target) and skips the block; check the axis words.</source>
        <translation>제어기가 error:33(잘못된 목표)로 응답하고 블록을 건너뜁니다. 축 워드를 확인하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:34 (arc radius) and skips the block; check R and the end point.</source>
        <translation>제어기가 error:34(원호 반경)으로 응답하고 블록을 건너뜁니다. R과 끝점을 확인하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:35 (no centre in the plane) and skips the block; give I, J or K of the plane, or R.</source>
        <translation>제어기가 error:35(평면에 중심 없음)으로 응답하고 블록을 건너뜁니다. 평면의 I, J, K 또는 R을 지정하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:36 (unused words) and skips the block; keep the centre or the radius.</source>
        <translation>제어기가 error:36(사용되지 않은 워드)로 응답하고 블록을 건너뜁니다. 중심이나 반경 중 하나만 남기십시오.</translation>
    </message>
    <message>
        <source>The control reports error:36 (unused words) and skips the block; remove the word.</source>
        <translation>제어기가 error:36(사용되지 않은 워드)로 응답하고 블록을 건너뜁니다. 워드를 삭제하십시오.</translation>
    </message>
    <message>
        <source>The control reports error:37 and skips the block; write G43.1 Z… alone.</source>
        <translation>제어기가 error:37로 응답하고 블록을 건너뜁니다. G43.1 Z…만 쓰십시오.</translation>
    </message>
    <message>
        <source>seek the reference switches</source>
        <translation>원점 스위치 찾기</translation>
    </message>
    <message>
        <source>work offset 6, or by number</source>
        <translation>공작물 좌표계 6, 또는 번호로 지정</translation>
    </message>
    <message>
        <source>restart the program</source>
        <translation>프로그램 다시 시작</translation>
    </message>
    <message>
        <source>The program has N{} more than once; the jump goes to the one in line {}.</source>
        <translation>프로그램에 N{} 블록이 둘 이상 있으며, 점프는 {}번 줄의 블록으로 갑니다.</translation>
    </message>
    <message>
        <source>Controls search in different directions; give each target a number of its own.</source>
        <translation>제어기마다 찾는 방향이 다릅니다. 점프 대상마다 고유한 번호를 지정하십시오.</translation>
    </message>
    <message>
        <source>{} belongs to no modal group of milling that the manuals name.</source>
        <translation>{} 변수는 설명서에 나오는 밀링용 모달 그룹에 속하지 않습니다.</translation>
    </message>
    <message>
        <source>Only the control knows its value; what follows from it is unverified.</source>
        <translation>그 값은 제어기만 알 수 있으므로 이에 따른 결과는 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>{} is not supported by this control.</source>
        <translation>이 제어기는 {}을(를) 지원하지 않습니다.</translation>
    </message>
    <message>
        <source>The control skips the block, and so does the simulation; remove the code.</source>
        <translation>제어기와 시뮬레이션 모두 블록을 건너뜁니다. 코드를 삭제하십시오.</translation>
    </message>
    <message>
        <source>This control has no word {}.</source>
        <translation>이 제어기에는 {} 워드가 없습니다.</translation>
    </message>
    <message>
        <source>The control skips the block, and so does the simulation; remove the word.</source>
        <translation>제어기와 시뮬레이션 모두 블록을 건너뜁니다. 워드를 삭제하십시오.</translation>
    </message>
    <message>
        <source>This control has neither parameters nor expressions.</source>
        <translation>이 제어기에는 파라미터도 수식도 없습니다.</translation>
    </message>
    <message>
        <source>Let the CAM system write plain numbers.</source>
        <translation>CAM 시스템에서 일반 숫자로 출력하십시오.</translation>
    </message>
    <message>
        <source>The line has {} characters without blanks and comments; the control reads no more than {}.</source>
        <translation>이 줄은 공백과 주석을 빼고 {}자인데 제어기는 {}자까지만 읽습니다.</translation>
    </message>
    <message>
        <source>The control reports error:11 and skips the line; split it.</source>
        <translation>제어기가 error:11로 응답하고 줄을 건너뜁니다. 줄을 나누십시오.</translation>
    </message>
    <message>
        <source>The block number is larger than {}.</source>
        <translation>블록 번호가 {}보다 큽니다.</translation>
    </message>
    <message>
        <source>The control reports error:27 and skips the block; renumber the blocks.</source>
        <translation>제어기가 error:27로 응답하고 블록을 건너뜁니다. 블록 번호를 다시 매기십시오.</translation>
    </message>
    <message>
        <source>{} is a command to the control itself; it is not simulated.</source>
        <translation>{} 명령은 제어기 자체에 대한 것이므로 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>It may move axes, change settings or clear offsets; send it apart from the program.</source>
        <translation>축을 움직이거나 설정을 바꾸거나 옵셋을 지울 수 있습니다. 프로그램과 따로 보내십시오.</translation>
    </message>
    <message>
        <source>The character {} is a real-time command that acts anywhere, even in comments.</source>
        <translation>{} 문자는 실시간 명령이며 주석 안을 포함해 어디서나 작동합니다.</translation>
    </message>
    <message>
        <source>It may stop the machine or change an override; remove it.</source>
        <translation>기계를 멈추거나 오버라이드를 바꿀 수 있습니다. 삭제하십시오.</translation>
    </message>
    <message>
        <source>The character {} resets the control or stops it in the middle of the program.</source>
        <translation>{} 문자는 프로그램 도중에 제어기를 재설정하거나 멈춥니다.</translation>
    </message>
    <message>
        <source>Remove it.</source>
        <translation>삭제하십시오.</translation>
    </message>
    <message>
        <source>This control has no block delete: it runs what follows &quot;/&quot;.</source>
        <translation>이 제어기에는 블록 스킵이 없어 &quot;/&quot; 뒤의 내용을 실행합니다.</translation>
    </message>
    <message>
        <source>Remove the blocks that must not run.</source>
        <translation>실행하면 안 되는 블록을 삭제하십시오.</translation>
    </message>
    <message>
        <source>This control does not know &quot;%&quot;.</source>
        <translation>이 제어기는 &quot;%&quot;를 알지 못합니다.</translation>
    </message>
    <message>
        <source>The control reports error:1 unless the sender filters the line; remove it.</source>
        <translation>전송 프로그램이 그 줄을 걸러 내지 않으면 제어기가 error:1로 응답합니다. 삭제하십시오.</translation>
    </message>
    <message>
        <source>T{} is read, but changes nothing: this control has no tool change.</source>
        <translation>T{} 워드를 읽지만 아무것도 바뀌지 않습니다. 이 제어기에는 공구 교환이 없습니다.</translation>
    </message>
    <message>
        <source>Make one program per tool, or change the tool by hand after M0.</source>
        <translation>공구마다 프로그램을 따로 만들거나 M0 뒤에서 공구를 수동으로 교환하십시오.</translation>
    </message>
    <message>
        <source>This control does not stop at M1.</source>
        <translation>이 제어기는 M1에서 멈추지 않습니다.</translation>
    </message>
    <message>
        <source>Write M0 where it must stop.</source>
        <translation>멈춰야 하는 곳에 M0을 쓰십시오.</translation>
    </message>
    <message>
        <source>M7 is known only where grbl was built with mist coolant.</source>
        <translation>M7은 미스트 절삭유를 포함해 빌드한 grbl에서만 쓸 수 있습니다.</translation>
    </message>
    <message>
        <source>Otherwise grbl reports error:20 and skips the block; give M7 a block of its own.</source>
        <translation>그렇지 않으면 grbl이 error:20으로 응답하고 블록을 건너뜁니다. M7을 별도의 블록에 쓰십시오.</translation>
    </message>
    <message>
        <source>The centre word {} is outside the plane of the arc; the control ignores it.</source>
        <translation>중심 워드 {}은(는) 원호의 평면 밖에 있어 제어기가 무시합니다.</translation>
    </message>
    <message>
        <source>The arc has no end point in its plane.</source>
        <translation>원호의 평면에 끝점이 없습니다.</translation>
    </message>
    <message>
        <source>Write the end point, also of a full circle.</source>
        <translation>완전한 원에도 끝점을 쓰십시오.</translation>
    </message>
    <message>
        <source>G43.1 takes the word Z and no other axis on this control.</source>
        <translation>이 제어기에서 G43.1은 Z 워드만 받고 다른 축은 받지 않습니다.</translation>
    </message>
    <message>
        <source>Write G43.1 Z… in a block of its own.</source>
        <translation>G43.1 Z…를 별도의 블록에 쓰십시오.</translation>
    </message>
    <message>
        <source>This control knows O with a number alone, as the beginning of a subprogram.</source>
        <translation>이 제어기에서 O는 서브프로그램의 시작으로, 숫자와 함께만 쓸 수 있습니다.</translation>
    </message>
    <message>
        <source>Call it with M98 and end it with M99.</source>
        <translation>M98로 호출하고 M99로 끝내십시오.</translation>
    </message>
    <message>
        <source>A setting of the control decides whether the dwell of {} is {} s or {} s; it is taken as the first.</source>
        <translation>{}의 드웰 시간이 {}초인지 {}초인지는 제어기 설정에 따라 결정됩니다. 앞의 값으로 가정합니다.</translation>
    </message>
    <message>
        <source>Check on the control whether P counts seconds or milliseconds.</source>
        <translation>P가 초인지 밀리초인지 제어기에서 확인하십시오.</translation>
    </message>
    <message>
        <source>The arc fits with its centre from the start point and also from the origin; a setting of the control decides. The start point is assumed.</source>
        <translation>원호의 중심이 시작점 기준으로도 원점 기준으로도 맞습니다. 제어기 설정에 따라 결정되며 시작점 기준으로 가정합니다.</translation>
    </message>
    <message>
        <source>Write G91.1 or G90.1 at the beginning of the program.</source>
        <translation>프로그램 처음에 G91.1 또는 G90.1을 쓰십시오.</translation>
    </message>
    <message>
        <source>Mach3 uses the tool position as the pole of G16, Mach4 the origin; Mach3 is assumed.</source>
        <translation>G16의 극점으로 Mach3는 공구 위치를, Mach4는 원점을 씁니다. Mach3로 가정합니다.</translation>
    </message>
    <message>
        <source>Begin the polar coordinates where both are the same: at X0 Y0.</source>
        <translation>둘이 같은 곳인 X0 Y0에서 극좌표를 시작하십시오.</translation>
    </message>
    <message>
        <source>Polar coordinates are for G0 and G1 in the XY plane; their effect on {} is not documented.</source>
        <translation>극좌표는 XY 평면의 G0과 G1을 위한 것입니다. {}에 대한 효과는 문서에 없습니다.</translation>
    </message>
    <message>
        <source>Write G15 before it.</source>
        <translation>그 앞에 G15를 쓰십시오.</translation>
    </message>
    <message>
        <source>Whether G51 scales the word {} is not documented; it is assumed to.</source>
        <translation>G51이 {} 워드를 스케일링하는지는 문서에 없습니다. 스케일링한다고 가정합니다.</translation>
    </message>
    <message>
        <source>Write G50 before it, or give the centre of an arc by I and J.</source>
        <translation>그 앞에 G50을 쓰거나 원호의 중심을 I와 J로 지정하십시오.</translation>
    </message>
    <message>
        <source>{} works in the XY plane only.</source>
        <translation>{} 코드는 XY 평면에서만 동작합니다.</translation>
    </message>
    <message>
        <source>Write G17 before it; the code has no effect.</source>
        <translation>그 앞에 G17을 쓰십시오. 이 코드는 효과가 없습니다.</translation>
    </message>
    <message>
        <source>{} without H, or with H0, sets the tool length offset to 0.</source>
        <translation>H가 없거나 H0인 {} 코드는 공구 길이 보정을 0으로 합니다.</translation>
    </message>
    <message>
        <source>Write the tool number after H.</source>
        <translation>H 뒤에 공구 번호를 쓰십시오.</translation>
    </message>
    <message>
        <source>M47 restarts the program, endlessly.</source>
        <translation>M47은 프로그램을 끝없이 다시 시작합니다.</translation>
    </message>
    <message>
        <source>{} seeks the reference switches; the axis positions afterwards are unknown.</source>
        <translation>{} 코드는 원점 스위치를 찾습니다. 그 뒤의 축 위치는 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Position the axes before the next cut.</source>
        <translation>다음 절삭 전에 축의 위치를 정하십시오.</translation>
    </message>
    <message>
        <source>This block is unreachable: line {} always jumps past it.</source>
        <translation>이 블록에는 도달할 수 없습니다. {}번 줄이 항상 이 블록을 건너뜁니다.</translation>
    </message>
    <message>
        <source>Remove it, or give it the block number or label of a jump.</source>
        <translation>삭제하거나 점프에 쓰인 블록 번호 또는 레이블을 붙이십시오.</translation>
    </message>
    <message>
        <source>T{} is selected, but the tool table does not have it.</source>
        <translation>T{}을(를) 선택했지만 공구 테이블에 없습니다.</translation>
    </message>
    <message>
        <source>Add the tool, or correct the number.</source>
        <translation>공구를 추가하거나 번호를 고치십시오.</translation>
    </message>
    <message>
        <source>chamfer</source>
        <translation>모따기</translation>
    </message>
    <message>
        <source>corner radius</source>
        <translation>코너 반경</translation>
    </message>
    <message>
        <source>The chamfer or corner radius is not between two straight or circular motions (alarm 051).</source>
        <translation>모따기 또는 코너 반경이 두 직선 또는 원호 이동 사이에 있지 않습니다(알람 051).</translation>
    </message>
    <message>
        <source>Program G1, G2 or G3 in the plane next; the corner stays sharp.</source>
        <translation>다음에 평면 안의 G1, G2 또는 G3을 지령하십시오. 코너는 그대로 남습니다.</translation>
    </message>
    <message>
        <source>The chamfer or corner radius of {} mm does not fit between the motions (alarm 055).</source>
        <translation>{} mm의 모따기 또는 코너 반경이 이동 사이에 들어가지 않습니다(알람 055).</translation>
    </message>
    <message>
        <source>Use a smaller one; the corner stays sharp.</source>
        <translation>더 작은 값을 쓰십시오. 코너는 그대로 남습니다.</translation>
    </message>
    <message>
        <source>A chamfer or corner radius needs motions in one plane on both sides.</source>
        <translation>모따기 또는 코너 반경의 양쪽에는 한 평면 안의 이동이 필요합니다.</translation>
    </message>
    <message>
        <source>Move along the third axis in another block; the corner stays sharp.</source>
        <translation>제3축은 다른 블록에서 움직이십시오. 코너는 그대로 남습니다.</translation>
    </message>
    <message>
        <source>The manuals do not say how a chamfer is measured along an arc; here it is the straight distance from the corner.</source>
        <translation>원호에서 모따기를 어떻게 재는지는 설명서에 없습니다. 여기서는 코너로부터의 직선 거리입니다.</translation>
    </message>
    <message>
        <source>Write the motions out.</source>
        <translation>이동을 직접 풀어 쓰십시오.</translation>
    </message>
    <message>
        <source>#5061 to #5063 hold that end. With a stock and a cutter for its tool it stops at the stock.</source>
        <translation>#5061에서 #5063까지는 이 끝점의 값입니다. 소재와 그 공구의 커터가 정의되어 있으면 소재에서 멈춥니다.</translation>
    </message>
    <message>
        <source>It is assumed to move to its programmed end; #5061 to #5069 hold that, #5070 is 0. With a stock and a cutter for its tool it stops at the stock.</source>
        <translation>프로그램된 끝점까지 이동한다고 가정합니다. #5061에서 #5069까지는 그 값이고 #5070은 0입니다. 소재와 그 공구의 커터가 정의되어 있으면 소재에서 멈춥니다.</translation>
    </message>
    <message>
        <source>The probe is assumed to stop at X{} Y{} Z{} mm, where it touches the simulated stock.</source>
        <translation>프로브는 시뮬레이션된 소재에 닿는 X{} Y{} Z{} mm에서 멈춘다고 가정합니다.</translation>
    </message>
    <message>
        <source>On the machine the part decides; results are verified as long as the program does not continue from there or read the result.</source>
        <translation>기계에서는 공작물이 결정합니다. 프로그램이 그 위치에서 이어 가거나 결과를 읽지 않는 한 결과는 검증됩니다.</translation>
    </message>
    <message>
        <source>The probe is assumed to stop at X{} Y{} Z{} mm, where it leaves the simulated stock.</source>
        <translation>프로브는 시뮬레이션된 소재에서 떨어지는 X{} Y{} Z{} mm에서 멈춘다고 가정합니다.</translation>
    </message>
    <message>
        <source>This line uses a probing result, which is assumed from the simulated stock.</source>
        <translation>이 줄은 프로빙 결과를 사용하며, 그 값은 시뮬레이션된 소재에서 가정한 것입니다.</translation>
    </message>
    <message>
        <source>Results are shown for that stop; on another part they are unverified.</source>
        <translation>결과는 그 정지 위치에 대해 표시됩니다. 다른 공작물에서는 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>{} reaches its end without touching the simulated stock; the control stops there.</source>
        <translation>{}이(가) 시뮬레이션된 소재에 닿지 않고 끝에 도달합니다. 제어기는 거기에서 멈춥니다.</translation>
    </message>
    <message>
        <source>Check stock, tool and offsets, or probe farther.</source>
        <translation>소재, 공구, 옵셋을 확인하거나 더 멀리 프로빙하십시오.</translation>
    </message>
    <message>
        <source>{} reaches its end without leaving the simulated stock; the control stops there.</source>
        <translation>{}이(가) 시뮬레이션된 소재에서 떨어지지 않고 끝에 도달합니다. 제어기는 거기에서 멈춥니다.</translation>
    </message>
    <message>
        <source>Check stock, tool and offsets, or move farther.</source>
        <translation>소재, 공구, 옵셋을 확인하거나 더 멀리 이동하십시오.</translation>
    </message>
    <message>
        <source>{} begins where the probe touches the simulated stock; the control stops there.</source>
        <translation>{}이(가) 프로브가 시뮬레이션된 소재에 닿아 있는 곳에서 시작합니다. 제어기는 거기에서 멈춥니다.</translation>
    </message>
    <message>
        <source>Retract before it; the motion is skipped.</source>
        <translation>그 전에 후퇴하십시오. 이 이동은 건너뜁니다.</translation>
    </message>
    <message>
        <source>{} begins where the probe touches nothing of the simulated stock; the control stops there.</source>
        <translation>{}이(가) 프로브가 시뮬레이션된 소재에 닿지 않은 곳에서 시작합니다. 제어기는 거기에서 멈춥니다.</translation>
    </message>
    <message>
        <source>Touch the part before it; the motion is skipped.</source>
        <translation>그 전에 공작물에 닿게 하십시오. 이 이동은 건너뜁니다.</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>파라미터</translation>
    </message>
    <message>
        <source>The block after the chamfer or corner radius has no G1, G2 or G3 (alarm 052, on newer controls 051).</source>
        <translation>모따기 또는 코너 반경 다음 블록에 G1, G2, G3이 없습니다(알람 052, 새 제어기에서는 051).</translation>
    </message>
    <message>
        <source>Only one dwell, in a block of its own, is allowed between them; the corner stays sharp.</source>
        <translation>그 사이에는 단독 블록의 드웰 하나만 허용됩니다. 코너는 그대로 남습니다.</translation>
    </message>
    <message>
        <source>The block has both a chamfer and a corner radius (alarm 053).</source>
        <translation>블록에 모따기와 코너 반경이 모두 있습니다(알람 053).</translation>
    </message>
    <message>
        <source>Keep one of them; the corner stays sharp.</source>
        <translation>하나만 남기십시오. 코너는 그대로 남습니다.</translation>
    </message>
    <message>
        <source>Expected C or R after the comma (alarm 053).</source>
        <translation>쉼표 뒤에 C 또는 R이 와야 합니다(알람 053).</translation>
    </message>
    <message>
        <source>Write ,C for a chamfer and ,R for a corner radius.</source>
        <translation>모따기는 ,C, 코너 반경은 ,R로 쓰십시오.</translation>
    </message>
    <message>
        <source>The chamfer or corner radius of {} mm is negative.</source>
        <translation>{} mm의 모따기 또는 코너 반경은 음수입니다.</translation>
    </message>
    <message>
        <source>Write it without a sign; the corner stays sharp.</source>
        <translation>부호 없이 쓰십시오. 코너는 그대로 남습니다.</translation>
    </message>
    <message>
        <source>The manuals do not say whether G51 also scales chamfers and corner radii; here it does not.</source>
        <translation>G51이 모따기와 코너 반경도 스케일링하는지 설명서에 없습니다. 여기서는 스케일링하지 않습니다.</translation>
    </message>
    <message>
        <source>A setting of the control decides whether G68 with G91 adds its angle to the active one (Fanuc: parameter 5400#0, Haas: setting 73); here the angle is {} degrees.</source>
        <translation>G91에서 G68이 각도를 유효한 각도에 더하는지는 제어기 설정에 따라 결정됩니다(Fanuc: 파라미터 5400#0, Haas: 세팅 73). 여기서 각도는 {}도입니다.</translation>
    </message>
    <message>
        <source>Write G90 before G68, or G69 between them.</source>
        <translation>G68 앞에 G90을 쓰거나 그 사이에 G69를 쓰십시오.</translation>
    </message>
    <message>
        <source>{} is not allowed while a canned cycle is active (alarm 044).</source>
        <translation>고정 사이클이 유효한 동안에는 {}을(를) 쓸 수 없습니다(알람 044).</translation>
    </message>
    <message>
        <source>End the cycle with G80 before it.</source>
        <translation>그 앞에서 G80으로 사이클을 끝내십시오.</translation>
    </message>
    <message>
        <source>A chamfer or corner radius is not allowed where cutter compensation starts, ends or changes side (alarm 039).</source>
        <translation>공구경 보정이 시작되거나 끝나거나 방향이 바뀌는 곳에는 모따기 또는 코너 반경을 쓸 수 없습니다(알람 039).</translation>
    </message>
    <message>
        <source>Put it between other motions; the corner stays sharp.</source>
        <translation>다른 이동 사이에 두십시오. 코너는 그대로 남습니다.</translation>
    </message>
    <message>
        <source>Reading the file was cancelled.</source>
        <translation>파일 읽기를 취소했습니다.</translation>
    </message>
    <message>
        <source>There is not enough memory to read the file.</source>
        <translation>파일을 읽는 데 필요한 메모리가 부족합니다.</translation>
    </message>
    <message>
        <source>Reading the file failed: {}.</source>
        <translation>파일 읽기에 실패했습니다: {}.</translation>
    </message>
    <message>
        <source>The file was not opened because the open program was edited while the file was being read.</source>
        <translation>파일을 읽는 동안 열려 있는 프로그램이 변경되어 파일을 열지 않았습니다.</translation>
    </message>
    <message>
        <source>More than five brackets are nested; the control gives alarm 118.</source>
        <translation>괄호가 다섯 단계보다 깊게 중첩되어 있습니다. 제어기는 알람 118을 냅니다.</translation>
    </message>
    <message>
        <source>The centre of {} is the current position, which is unknown for {}.</source>
        <translation>{}의 중심은 현재 위치이지만 {}의 현재 위치를 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Program the centre, or position the tool first.</source>
        <translation>중심을 지령하거나 먼저 공구의 위치를 정하십시오.</translation>
    </message>
    <message>
        <source>The profile at character {} has no width.</source>
        <translation>{}번째 문자의 프로파일에 폭이 없습니다.</translation>
    </message>
    <message>
        <source>The profile continues at character {} after {} points; it may have no more.</source>
        <translation>{}번째 문자에서 프로파일이 점 {}개를 넘어 이어집니다. 그보다 많이 가질 수 없습니다.</translation>
    </message>
    <message>
        <source>At character {} the profile turns back towards the axis.</source>
        <translation>{}번째 문자에서 프로파일이 축 쪽으로 되돌아갑니다.</translation>
    </message>
    <message>
        <source>At character {}, “{}” is not a profile point; a point is written as {}, an arc to it as {} or {}.</source>
        <translation>{}번째 문자의 “{}”은(는) 프로파일의 점이 아닙니다. 점은 {}처럼, 그 점까지의 원호는 {} 또는 {}처럼 씁니다.</translation>
    </message>
    <message>
        <source>At character {} the profile falls; from the axis outwards it may only rise or stay.</source>
        <translation>{}번째 문자에서 프로파일이 내려갑니다. 축에서 바깥쪽으로는 올라가거나 같은 높이여야 합니다.</translation>
    </message>
    <message>
        <source>At character {} the profile begins with “{}”, not at the tip, {}.</source>
        <translation>{1}번째 문자에서 프로파일이 선단 {3}이(가) 아니라 “{2}”(으)로 시작합니다.</translation>
    </message>
    <message>
        <source>The arc at character {} has the radius {} mm, too small for ends {} mm apart.</source>
        <translation>{}번째 문자의 원호는 반경이 {} mm로, 간격이 {} mm인 끝점에는 너무 작습니다.</translation>
    </message>
    <message>
        <source>The arc at character {} has ends that are {} mm and {} mm away from its centre.</source>
        <translation>{}번째 문자의 원호는 두 끝점이 중심에서 {} mm와 {} mm 떨어져 있습니다.</translation>
    </message>
    <message>
        <source>The arc at character {} falls or turns back towards the axis; it may be a quarter of a circle at most, from level to upright.</source>
        <translation>{}번째 문자의 원호가 내려가거나 축 쪽으로 되돌아갑니다. 수평에서 수직까지 최대 사분원이어야 합니다.</translation>
    </message>
    <message>
        <source>Before character {} the profile rises on the axis itself; its tip has no width.</source>
        <translation>{}번째 문자 앞에서 프로파일이 축 위에서 올라가므로 선단에 폭이 없습니다.</translation>
    </message>
    <message>
        <source>The arcs up to character {} are so large that they take more than {} lines.</source>
        <translation>{}번째 문자까지의 원호가 너무 커서 직선이 {}개보다 많이 필요합니다.</translation>
    </message>
    <message>
        <source>The pilot, pilot={}, is not smaller than the diameter, {} mm.</source>
        <translation>파일럿 pilot={}이(가) 지름 {} mm보다 작지 않습니다.</translation>
    </message>
    <message>
        <source>The pilot, pl={}, is shorter than its point, {} mm.</source>
        <translation>파일럿 길이 pl={}이(가) 선단 높이 {} mm보다 짧습니다.</translation>
    </message>
    <message>
        <source>The lead, lead={}, ends in a point; {} mm is the longest.</source>
        <translation>절입부 lead={}이(가) 한 점에서 만납니다. 최대 길이는 {} mm입니다.</translation>
    </message>
    <message>
        <source>The height h={} is not more than that of the rounded tip, {} mm.</source>
        <translation>높이 h={}이(가) 둥근 선단의 높이 {} mm보다 크지 않습니다.</translation>
    </message>
    <message>
        <source>The neck, neck={}, must be thinner than {} mm, the head at its top.</source>
        <translation>목 neck={}은(는) 머리 윗면의 지름 {} mm보다 가늘어야 합니다.</translation>
    </message>
    <message>
        <source>With h={} the flanks meet below the top; {} mm is the limit.</source>
        <translation>h={}이면 옆면이 윗면 아래에서 만납니다. 한계는 {} mm입니다.</translation>
    </message>
    <message>
        <source>A cutter of the shape {} needs the key {} ({}), e.g. {}.</source>
        <translation>{} 형상의 커터에는 키 {}({})이(가) 필요합니다. 예: {}.</translation>
    </message>
    <message>
        <source>The corner radius r={} does not fit; {} mm is the largest.</source>
        <translation>코너 반경 r={}이(가) 맞지 않습니다. 최댓값은 {} mm입니다.</translation>
    </message>
    <message>
        <source>Angle of each side</source>
        <translation>한쪽 각도</translation>
    </message>
    <message>
        <source>Height of the taper</source>
        <translation>테이퍼 높이</translation>
    </message>
    <message>
        <source>Diameter at the tip</source>
        <translation>선단 지름</translation>
    </message>
    <message>
        <source>Diameter of the ball</source>
        <translation>볼 지름</translation>
    </message>
    <message>
        <source>Diameter of the pilot</source>
        <translation>파일럿 지름</translation>
    </message>
    <message>
        <source>Length of the pilot with its point</source>
        <translation>선단을 포함한 파일럿 길이</translation>
    </message>
    <message>
        <source>Point angle of the pilot</source>
        <translation>파일럿 선단각</translation>
    </message>
    <message>
        <source>Length of the lead</source>
        <translation>절입부 길이</translation>
    </message>
    <message>
        <source>Approach angle of the edge</source>
        <translation>절삭날 접근각</translation>
    </message>
    <message>
        <source>Height of the edge</source>
        <translation>절삭날 높이</translation>
    </message>
    <message>
        <source>Profile, RADIUS/HEIGHT:… from the tip outwards</source>
        <translation>선단에서 바깥쪽으로 적은 프로파일, 반경/높이:… 형식</translation>
    </message>
    <message>
        <source>Diameter of the neck</source>
        <translation>목 지름</translation>
    </message>
    <message>
        <source>Width of the head</source>
        <translation>머리 폭</translation>
    </message>
    <message>
        <source>Angle between face and flank</source>
        <translation>밑면과 옆면 사이의 각도</translation>
    </message>
    <message>
        <source>Height of the head</source>
        <translation>머리 높이</translation>
    </message>
    <message>
        <source>Diameter of the neck (0: as the head&apos;s top)</source>
        <translation>목 지름(0: 머리 윗면과 같음)</translation>
    </message>
    <message>
        <source>Tapered end mill</source>
        <translation>테이퍼 엔드밀</translation>
    </message>
    <message>
        <source>Tapered ball-end mill</source>
        <translation>테이퍼 볼 엔드밀</translation>
    </message>
    <message>
        <source>Chamfer mill</source>
        <translation>모따기 커터</translation>
    </message>
    <message>
        <source>Face mill</source>
        <translation>페이스 밀</translation>
    </message>
    <message>
        <source>Spot drill</source>
        <translation>스폿 드릴</translation>
    </message>
    <message>
        <source>Centre drill</source>
        <translation>센터 드릴</translation>
    </message>
    <message>
        <source>Reamer</source>
        <translation>리머</translation>
    </message>
    <message>
        <source>Tap</source>
        <translation>탭</translation>
    </message>
    <message>
        <source>Thread mill</source>
        <translation>나사 밀</translation>
    </message>
    <message>
        <source>Lollipop cutter</source>
        <translation>롤리팝 커터</translation>
    </message>
    <message>
        <source>T-slot or keyseat cutter</source>
        <translation>T홈 또는 키홈 커터</translation>
    </message>
    <message>
        <source>Dovetail cutter</source>
        <translation>더브테일 커터</translation>
    </message>
    <message>
        <source>Form cutter</source>
        <translation>총형 커터</translation>
    </message>
    <message>
        <source>The neck of the cutter passes through {} mm of stock above its head.</source>
        <translation>커터의 목이 머리 위쪽 소재 {} mm를 지나갑니다.</translation>
    </message>
    <message>
        <source>Cut a slot for the neck first, or choose a tool with a thinner neck.</source>
        <translation>먼저 목이 지나갈 홈을 가공하거나 목이 더 가는 공구를 선택하십시오.</translation>
    </message>
    <message>
        <source>Above the head of the cutter {} mm³ of stock remain, which the z-map shows as removed; the layer is highest at X{} Y{} Z{}.</source>
        <translation>커터 머리 위에 소재 {} mm³가 남지만 Z맵에는 제거된 것으로 표시됩니다. 남은 층은 X{} Y{} Z{}에서 가장 높습니다.</translation>
    </message>
    <message>
        <source>Check by other means what is cut there from here on.</source>
        <translation>여기부터 그곳의 절삭은 다른 방법으로 확인하십시오.</translation>
    </message>
    <message>
        <source>Proveout stock</source>
        <translation>Proveout 소재</translation>
    </message>
    <message>
        <source>the stock left by a setup</source>
        <translation>한 셋업이 남긴 소재</translation>
    </message>
    <message>
        <source>This line is not a point: X, Y and, for an arc, its bulge.</source>
        <translation>이 줄은 점이 아닙니다. X, Y, 그리고 원호라면 벌지가 있어야 합니다.</translation>
    </message>
    <message>
        <source>The loop that ends here has only one point.</source>
        <translation>여기서 끝나는 윤곽에는 점이 하나뿐입니다.</translation>
    </message>
    <message>
        <source>The outline has no points.</source>
        <translation>윤곽에 점이 없습니다.</translation>
    </message>
    <message>
        <source>“{}” is not a key of this stock shape; there are {}.</source>
        <translation>“{}”은(는) 이 소재 형상의 키가 아닙니다. 사용할 수 있는 키: {}.</translation>
    </message>
    <message>
        <source>{}={} is not a length above {} and at most {} mm.</source>
        <translation>{}={}은(는) {} 초과 {} mm 이하의 길이가 아닙니다.</translation>
    </message>
    <message>
        <source>{}={} is not one of {}.</source>
        <translation>{}={}은(는) 다음 중 하나가 아닙니다: {}.</translation>
    </message>
    <message>
        <source>The key {} must name a file.</source>
        <translation>키 {}에는 파일 이름이 있어야 합니다.</translation>
    </message>
    <message>
        <source>A stock of the shape {} needs the key {}, as in {}.</source>
        <translation>{} 형상의 소재에는 키 {}이(가) 필요합니다. 예: {}.</translation>
    </message>
    <message>
        <source>“{}” is not a stock shape; there are {}.</source>
        <translation>“{}”은(는) 소재 형상이 아닙니다. 사용할 수 있는 형상: {}.</translation>
    </message>
    <message>
        <source>The saved stock is cut off or damaged: {} in it cannot be read whole.</source>
        <translation>저장된 소재가 잘렸거나 손상되었습니다. 그 안의 {}을(를) 끝까지 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>This is not a stock that Proveout has saved.</source>
        <translation>Proveout이 저장한 소재가 아닙니다.</translation>
    </message>
    <message>
        <source>The stock was saved by a newer Proveout (format {}); this one reads up to format {}.</source>
        <translation>더 새로운 Proveout이 저장한 소재입니다(형식 {}). 이 버전은 형식 {}까지 읽습니다.</translation>
    </message>
    <message>
        <source>The saved stock specifies {} × {} points, but its size and spacing give {} × {}.</source>
        <translation>저장된 소재에는 점이 {} × {}개로 지정되어 있지만 크기와 격자 간격으로는 {} × {}개입니다.</translation>
    </message>
    <message>
        <source>The heights of the saved stock are not {} × {} numbers of float32.</source>
        <translation>저장된 소재의 높이가 float32 수 {} × {}개가 아닙니다.</translation>
    </message>
    <message>
        <source>Row {}, column {} of the saved stock is not a height within it.</source>
        <translation>저장된 소재의 {}행 {}열은 소재 안의 높이가 아닙니다.</translation>
    </message>
    <message>
        <source>Height Z</source>
        <translation>높이 Z</translation>
    </message>
    <message>
        <source>Size of the stock along Z, from its top downwards.</source>
        <translation>윗면에서 아래로 잰 소재의 Z 방향 크기입니다.</translation>
    </message>
    <message>
        <source>Width X</source>
        <translation>폭 X</translation>
    </message>
    <message>
        <source>Size of the stock along X.</source>
        <translation>소재의 X 방향 크기입니다.</translation>
    </message>
    <message>
        <source>Length Y</source>
        <translation>길이 Y</translation>
    </message>
    <message>
        <source>Size of the stock along Y.</source>
        <translation>소재의 Y 방향 크기입니다.</translation>
    </message>
    <message>
        <source>Diameter of the upright cylinder.</source>
        <translation>세워진 원기둥의 지름입니다.</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>윤곽</translation>
    </message>
    <message>
        <source>A text file with one point X Y per line, and a third number for an arc to the next point: the tangent of a quarter of its angle. An empty line begins another loop.</source>
        <translation>한 줄에 점 X Y가 하나씩 있는 텍스트 파일입니다. 세 번째 수는 다음 점까지의 원호를 나타내며, 원호 각도의 4분의 1의 탄젠트입니다. 빈 줄은 다른 윤곽을 시작합니다.</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>메시</translation>
    </message>
    <message>
        <source>A closed mesh, in mm; the stock is everything below its upper surface.</source>
        <translation>닫힌 메시(mm)입니다. 그 윗면 아래가 소재입니다.</translation>
    </message>
    <message>
        <source>Not turned</source>
        <translation>돌리지 않음</translation>
    </message>
    <message>
        <source>90° to the left</source>
        <translation>왼쪽으로 90°</translation>
    </message>
    <message>
        <source>180°</source>
        <translation>180°</translation>
    </message>
    <message>
        <source>90° to the right</source>
        <translation>오른쪽으로 90°</translation>
    </message>
    <message>
        <source>Not flipped</source>
        <translation>뒤집지 않음</translation>
    </message>
    <message>
        <source>About X</source>
        <translation>X축으로</translation>
    </message>
    <message>
        <source>About Y</source>
        <translation>Y축으로</translation>
    </message>
    <message>
        <source>Saved stock</source>
        <translation>저장된 소재</translation>
    </message>
    <message>
        <source>The stock left by an earlier setup, as saved by File, Save Stock.</source>
        <translation>이전 셋업이 남긴 소재로, 파일 메뉴의 소재 저장으로 저장한 것입니다.</translation>
    </message>
    <message>
        <source>Flipped</source>
        <translation>뒤집기</translation>
    </message>
    <message>
        <source>By half a turn, so that the underside is on top; before it is turned.</source>
        <translation>반 바퀴 돌려 아랫면이 위로 오게 합니다. 돌리기 전에 합니다.</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>돌리기</translation>
    </message>
    <message>
        <source>About the upright axis, seen from above.</source>
        <translation>위에서 보아 수직축을 중심으로 돌립니다.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>직육면체</translation>
    </message>
    <message>
        <source>A block with its sides along the axes.</source>
        <translation>변이 축과 나란한 블록입니다.</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>원기둥</translation>
    </message>
    <message>
        <source>A round bar that stands upright.</source>
        <translation>세워 놓은 둥근 봉입니다.</translation>
    </message>
    <message>
        <source>Extruded outline</source>
        <translation>돌출 윤곽</translation>
    </message>
    <message>
        <source>A plate within a closed outline of lines and arcs, with holes.</source>
        <translation>직선과 원호로 된 닫힌 윤곽 안의 판이며 구멍이 있을 수 있습니다.</translation>
    </message>
    <message>
        <source>Mesh (STL)</source>
        <translation>메시 (STL)</translation>
    </message>
    <message>
        <source>A casting or a forging, as a closed mesh.</source>
        <translation>닫힌 메시로 된 주조품이나 단조품입니다.</translation>
    </message>
    <message>
        <source>The stock left by an earlier setup, also flipped or turned.</source>
        <translation>이전 셋업이 남긴 소재로, 뒤집거나 돌릴 수도 있습니다.</translation>
    </message>
    <message>
        <source>This is not a ZIP archive, or one that cannot be read.</source>
        <translation>ZIP 압축 파일이 아니거나 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>The outline has a point beyond {} mm, or an arc that is nearly a full circle.</source>
        <translation>윤곽에 {} mm를 넘는 점이나 거의 완전한 원인 원호가 있습니다.</translation>
    </message>
    <message>
        <source>The outline crosses itself near X{} Y{}.</source>
        <translation>윤곽이 X{} Y{} 근처에서 스스로 교차합니다.</translation>
    </message>
    <message>
        <source>The outline encloses no area.</source>
        <translation>윤곽이 둘러싼 면적이 없습니다.</translation>
    </message>
    <message>
        <source>The mesh of the stock is not closed: at {} of {} grid points the material is unknown.</source>
        <translation>소재의 메시가 닫혀 있지 않습니다. 격자점 {2}개 중 {1}개에서 재료를 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Export the stock as a closed solid.</source>
        <translation>소재를 닫힌 솔리드로 내보내십시오.</translation>
    </message>
    <message>
        <source>The mesh of the stock reaches beyond {} mm.</source>
        <translation>소재의 메시가 {} mm를 넘어갑니다.</translation>
    </message>
    <message>
        <source>The mesh of the stock encloses no volume.</source>
        <translation>소재의 메시가 둘러싼 부피가 없습니다.</translation>
    </message>
    <message>
        <source>The facets of the stock mesh are in {} layers on average; at most {} can be read.</source>
        <translation>소재 메시의 면이 평균 {}겹입니다. 최대 {}겹까지 읽을 수 있습니다.</translation>
    </message>
    <message>
        <source>The saved stock has a spacing of {} × {} mm and is resampled to {} × {} mm: never lower at its points, between them up to one spacing wider.</source>
        <translation>저장된 소재의 격자 간격은 {} × {} mm이며 {} × {} mm로 재샘플링됩니다. 점에서는 낮아지지 않으며 그 사이는 최대 한 간격만큼 넓어집니다.</translation>
    </message>
    <message>
        <source>Use the spacing of the saved stock, or a whole fraction of it, to avoid resampling.</source>
        <translation>재샘플링을 피하려면 저장된 소재의 격자 간격이나 그 정수분의 1을 쓰십시오.</translation>
    </message>
    <message>
        <source>No stock is left in the saved stock.</source>
        <translation>저장된 소재에 남은 것이 없습니다.</translation>
    </message>
    <message>
        <source>Below the surface of the stock there are {} mm³ of air, which the z-map shows as material; the tallest gap, {} mm, starts at X{} Y{} Z{}.</source>
        <translation>소재의 표면 아래에 {} mm³의 빈 공간이 있지만 Z맵에는 재료로 표시됩니다. 가장 높은 틈({} mm)은 X{} Y{} Z{}에서 시작합니다.</translation>
    </message>
    <message>
        <source>Check the program over such gaps by other means.</source>
        <translation>이런 틈 위의 프로그램은 다른 방법으로 확인하십시오.</translation>
    </message>
    <message>
        <source>There is not enough memory for the stock.</source>
        <translation>소재에 필요한 메모리가 부족합니다.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>줄</translation>
    </message>
    <message>
        <source>Stop before a line of the program.</source>
        <translation>프로그램의 한 줄 앞에서 멈춥니다.</translation>
    </message>
    <message>
        <source>Stopped before line {}.</source>
        <translation>{}번 줄 앞에서 멈췄습니다.</translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation>공구 교환</translation>
    </message>
    <message>
        <source>Stop at each tool change.</source>
        <translation>공구를 교환할 때마다 멈춥니다.</translation>
    </message>
    <message>
        <source>Stopped at a tool change.</source>
        <translation>공구 교환에서 멈췄습니다.</translation>
    </message>
    <message>
        <source>M0 or M1</source>
        <translation>M0 또는 M1</translation>
    </message>
    <message>
        <source>Stop at M0, M1 or M60.</source>
        <translation>M0, M1 또는 M60에서 멈춥니다.</translation>
    </message>
    <message>
        <source>Program stop (M0, M1 or M60).</source>
        <translation>프로그램 정지(M0, M1 또는 M60).</translation>
    </message>
    <message>
        <source>Z below</source>
        <translation>Z 아래</translation>
    </message>
    <message>
        <source>Stop before a block that goes below a height.</source>
        <translation>지정한 높이 아래로 내려가는 블록 앞에서 멈춥니다.</translation>
    </message>
    <message>
        <source>Stopped before going below Z {}.</source>
        <translation>Z {} 아래로 내려가기 전에 멈췄습니다.</translation>
    </message>
    <message>
        <source>First contact</source>
        <translation>첫 접촉</translation>
    </message>
    <message>
        <source>Stop after the first block of each tool that removes material.</source>
        <translation>공구마다 소재를 처음 제거한 블록 뒤에서 멈춥니다.</translation>
    </message>
    <message>
        <source>Stopped after the first contact of the tool.</source>
        <translation>공구의 첫 접촉 뒤에서 멈췄습니다.</translation>
    </message>
    <message>
        <source>On finding</source>
        <translation>결과 발견 시</translation>
    </message>
    <message>
        <source>Stop after a block with a finding.</source>
        <translation>문제가 발견된 블록 뒤에서 멈춥니다.</translation>
    </message>
    <message>
        <source>Stopped after a block with a finding.</source>
        <translation>문제가 발견된 블록 뒤에서 멈췄습니다.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>조건</translation>
    </message>
    <message>
        <source>Stop before a block where a condition becomes true.</source>
        <translation>조건이 성립하게 되는 블록 앞에서 멈춥니다.</translation>
    </message>
    <message>
        <source>Breakpoint: {}.</source>
        <translation>중단점: {}.</translation>
    </message>
    <message>
        <source>position X at the end of the motion, mm</source>
        <translation>이동 끝의 X 위치, mm</translation>
    </message>
    <message>
        <source>position Y at the end of the motion, mm</source>
        <translation>이동 끝의 Y 위치, mm</translation>
    </message>
    <message>
        <source>position Z at the end of the motion, mm</source>
        <translation>이동 끝의 Z 위치, mm</translation>
    </message>
    <message>
        <source>feed, mm/min; 0 at rapid</source>
        <translation>이송 속도, mm/min. 급속 이송은 0</translation>
    </message>
    <message>
        <source>spindle speed, rpm</source>
        <translation>주축 회전수, rpm</translation>
    </message>
    <message>
        <source>tool in the spindle</source>
        <translation>주축의 공구</translation>
    </message>
    <message>
        <source>number of the block, as the timeline counts</source>
        <translation>블록 번호(타임라인 기준)</translation>
    </message>
    <message>
        <source>line of the program</source>
        <translation>프로그램의 줄</translation>
    </message>
    <message>
        <source>Column {}: a number or one of the letters X Y Z F S T N L is expected here.</source>
        <translation>{}열: 여기에는 숫자나 X Y Z F S T N L 중 한 글자가 와야 합니다.</translation>
    </message>
    <message>
        <source>Column {}: one of &lt; &lt;= &gt; &gt;= == != is expected here.</source>
        <translation>{}열: 여기에는 &lt; &lt;= &gt; &gt;= == != 중 하나가 와야 합니다.</translation>
    </message>
    <message>
        <source>Column {}: &amp;&amp; or || is expected here.</source>
        <translation>{}열: 여기에는 &amp;&amp; 또는 || 가 와야 합니다.</translation>
    </message>
    <message>
        <source>Column {}: a closing parenthesis is expected here.</source>
        <translation>{}열: 여기에는 닫는 괄호가 와야 합니다.</translation>
    </message>
    <message>
        <source>Column {}: the parentheses are nested too deeply.</source>
        <translation>{}열: 괄호가 너무 깊게 중첩되어 있습니다.</translation>
    </message>
    <message>
        <source>A condition has {} characters at most.</source>
        <translation>조건은 최대 {}자입니다.</translation>
    </message>
    <message>
        <source>Unknown fixture shape</source>
        <translation>알 수 없는 고정구 형상</translation>
    </message>
    <message>
        <source>Unknown fixture key</source>
        <translation>알 수 없는 고정구 키</translation>
    </message>
    <message>
        <source>The shape of the fixture has no &quot;{}&quot;; it has {}.</source>
        <translation>고정구 형상에는 &quot;{}&quot;이(가) 없습니다. {}이(가) 있습니다.</translation>
    </message>
    <message>
        <source>Invalid fixture value</source>
        <translation>잘못된 고정구 값</translation>
    </message>
    <message>
        <source>&quot;{}&quot; of the fixture must be a number from {} to {}.</source>
        <translation>고정구의 &quot;{}&quot;은(는) {}에서 {} 사이의 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>Fixture without a name</source>
        <translation>이름 없는 고정구</translation>
    </message>
    <message>
        <source>The fixture needs a name, as in NAME=SHAPE:key=value.</source>
        <translation>고정구에는 NAME=SHAPE:key=value와 같이 이름이 필요합니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; is not a fixture: {}</source>
        <translation>필드 &quot;{}&quot;은(는) 고정구가 아닙니다: {}</translation>
    </message>
    <message>
        <source>The unconfirmed tool moves sideways in material, {} mm deep, but only cuts along its axis.</source>
        <translation>확인되지 않은 공구가 소재 안에서 {} mm 깊이로 옆으로 움직이지만, 이 공구는 축 방향으로만 절삭합니다.</translation>
    </message>
    <message>
        <source>Confirm the tool in the tool table, or choose another shape.</source>
        <translation>공구 테이블에서 공구를 확인하거나 다른 형상을 선택하십시오.</translation>
    </message>
    <message>
        <source>Spindle never turns</source>
        <translation>주축이 회전하지 않음</translation>
    </message>
    <message>
        <source>The cutter cuts {} mm deep, but the program never turns the spindle at a speed.</source>
        <translation>커터가 {} mm 깊이로 절삭하지만, 프로그램은 주축을 어떤 속도로도 회전시키지 않습니다.</translation>
    </message>
    <message>
        <source>Program M3 with a speed S, or make sure that the spindle turns.</source>
        <translation>속도 S와 함께 M3를 프로그램하거나 주축이 회전하는지 확인하십시오.</translation>
    </message>
    <message>
        <source>Fixture collision</source>
        <translation>고정구 충돌</translation>
    </message>
    <message>
        <source>The tool collides with the fixture &quot;{3}&quot;, {1} mm deep.</source>
        <translation>공구가 고정구 &quot;{3}&quot;와(과) {1} mm 깊이로 충돌합니다.</translation>
    </message>
    <message>
        <source>Move the fixture, or retract higher before the tool passes it.</source>
        <translation>고정구를 옮기거나, 공구가 지나가기 전에 더 높이 후퇴하십시오.</translation>
    </message>
    <message>
        <source>Fixture too near</source>
        <translation>고정구가 너무 가까움</translation>
    </message>
    <message>
        <source>The tool passes nearer than {2} mm to the fixture &quot;{3}&quot;, by {1} mm.</source>
        <translation>공구가 고정구 &quot;{3}&quot;에 {2} mm보다 {1} mm 더 가까이 지나갑니다.</translation>
    </message>
    <message>
        <source>Move the fixture, retract higher, or allow less clearance.</source>
        <translation>고정구를 옮기거나, 더 높이 후퇴하거나, 더 작은 간격을 허용하십시오.</translation>
    </message>
    <message>
        <source>Rapid close to stock</source>
        <translation>소재 가까이 급속 이송</translation>
    </message>
    <message>
        <source>The rapid move passes the stock {} mm closer than the clearance of {} mm.</source>
        <translation>급속 이송이 소재를 {1} mm 더 가까이 지나갑니다(간격 {2} mm).</translation>
    </message>
    <message>
        <source>Retract higher before the rapid, or reduce rapidClearance.</source>
        <translation>급속 이송 전에 더 높이 후퇴하거나 rapidClearance를 줄이십시오.</translation>
    </message>
    <message>
        <source>Axial depth too large</source>
        <translation>축 방향 절입 깊이 초과</translation>
    </message>
    <message>
        <source>The axial depth of cut of {} mm is above the maximum of the tool, {} mm.</source>
        <translation>축 방향 절입 깊이 {} mm가 공구의 최댓값 {} mm를 넘습니다.</translation>
    </message>
    <message>
        <source>Cut in shallower passes, or choose another tool.</source>
        <translation>더 얕게 나누어 절삭하거나 다른 공구를 선택하십시오.</translation>
    </message>
    <message>
        <source>Radial engagement too large</source>
        <translation>반경 방향 맞물림 초과</translation>
    </message>
    <message>
        <source>The radial engagement of {} mm is above the maximum of the tool, {} mm.</source>
        <translation>반경 방향 맞물림 {} mm가 공구의 최댓값 {} mm를 넘습니다.</translation>
    </message>
    <message>
        <source>Reduce the stepover, clear corners first, or choose another tool.</source>
        <translation>스텝오버를 줄이거나, 모서리를 먼저 가공하거나, 다른 공구를 선택하십시오.</translation>
    </message>
    <message>
        <source>Radial engagement jumps</source>
        <translation>반경 방향 맞물림 급변</translation>
    </message>
    <message>
        <source>From one block to the next the radial engagement more than doubles, to {} mm; the maximum of the tool is {} mm.</source>
        <translation>한 블록에서 다음 블록으로 반경 방향 맞물림이 두 배 넘게 늘어 {} mm가 됩니다. 공구의 최댓값은 {} mm입니다.</translation>
    </message>
    <message>
        <source>Round the corner, or clear it first.</source>
        <translation>모서리를 둥글게 하거나 먼저 가공하십시오.</translation>
    </message>
    <message>
        <source>Slot of full width</source>
        <translation>전폭 홈 가공</translation>
    </message>
    <message>
        <source>The tool cuts {} mm wide, a slot of its full diameter, {} mm; no radial limit is stated for it.</source>
        <translation>공구가 {} mm 폭으로, 전체 지름 {} mm의 홈을 절삭합니다. 반경 방향 한계가 지정되어 있지 않습니다.</translation>
    </message>
    <message>
        <source>State maxae for the tool if it may not, or turn this rule off.</source>
        <translation>허용되지 않으면 공구의 maxae를 지정하거나 이 규칙을 끄십시오.</translation>
    </message>
    <message>
        <source>Chips too thick</source>
        <translation>칩이 너무 두꺼움</translation>
    </message>
    <message>
        <source>The chip thickness of {} mm is above the maximum of the tool, {} mm.</source>
        <translation>칩 두께 {} mm가 공구의 최댓값 {} mm를 넘습니다.</translation>
    </message>
    <message>
        <source>Reduce the feed rate, or raise the spindle speed.</source>
        <translation>이송 속도를 줄이거나 주축 회전수를 높이십시오.</translation>
    </message>
    <message>
        <source>Surface speed too high</source>
        <translation>절삭 속도 초과</translation>
    </message>
    <message>
        <source>The surface speed of {} m/min is above the maximum of the tool, {} m/min.</source>
        <translation>절삭 속도 {} m/min이 공구의 최댓값 {} m/min을 넘습니다.</translation>
    </message>
    <message>
        <source>Reduce the spindle speed.</source>
        <translation>주축 회전수를 줄이십시오.</translation>
    </message>
    <message>
        <source>Removal rate too high</source>
        <translation>소재 제거율 초과</translation>
    </message>
    <message>
        <source>The tool removes {} cm³/min; its maximum is {} cm³/min.</source>
        <translation>공구가 {} cm³/min을 제거합니다. 최댓값은 {} cm³/min입니다.</translation>
    </message>
    <message>
        <source>Reduce the feed rate, the depth or the stepover.</source>
        <translation>이송 속도, 깊이 또는 스텝오버를 줄이십시오.</translation>
    </message>
    <message>
        <source>Feed above tool maximum</source>
        <translation>공구 최대 이송 초과</translation>
    </message>
    <message>
        <source>The tool cuts at a feed rate of {} mm/min; its maximum is {} mm/min.</source>
        <translation>공구가 이송 속도 {} mm/min으로 절삭합니다. 최댓값은 {} mm/min입니다.</translation>
    </message>
    <message>
        <source>Reduce F, or correct maxfeed of the tool.</source>
        <translation>F를 줄이거나 공구의 maxfeed를 고치십시오.</translation>
    </message>
    <message>
        <source>Spindle above tool maximum</source>
        <translation>공구 최대 회전수 초과</translation>
    </message>
    <message>
        <source>The tool turns at {} rpm; its maximum is {} rpm.</source>
        <translation>공구가 {} rpm으로 회전합니다. 최댓값은 {} rpm입니다.</translation>
    </message>
    <message>
        <source>Reduce S, or correct maxrpm of the tool.</source>
        <translation>S를 줄이거나 공구의 maxrpm을 고치십시오.</translation>
    </message>
    <message>
        <source>Spindle speed too high</source>
        <translation>주축 회전수 초과</translation>
    </message>
    <message>
        <source>The spindle speed of {} rpm is above the maximum of the machine, {} rpm.</source>
        <translation>주축 회전수 {} rpm이 기계의 최댓값 {} rpm을 넘습니다.</translation>
    </message>
    <message>
        <source>Reduce S, or correct the machine values.</source>
        <translation>S를 줄이거나 기계 값을 고치십시오.</translation>
    </message>
    <message>
        <source>Ramp too steep</source>
        <translation>램프가 너무 가파름</translation>
    </message>
    <message>
        <source>The tool goes down into material at {}°; its steepest ramp is {}°.</source>
        <translation>공구가 {}°로 소재에 들어갑니다. 가장 가파른 램프는 {}°입니다.</translation>
    </message>
    <message>
        <source>Lengthen the ramp or the helix, or drill a hole for the tool first.</source>
        <translation>램프나 나선을 길게 하거나, 먼저 공구가 들어갈 구멍을 뚫으십시오.</translation>
    </message>
    <message>
        <source>Tap out of step</source>
        <translation>탭 동기 불일치</translation>
    </message>
    <message>
        <source>The tap moves at a feed rate of {} mm/min; its pitch and the spindle speed need {} mm/min.</source>
        <translation>탭이 이송 속도 {} mm/min으로 움직입니다. 피치와 주축 회전수에는 {} mm/min이 필요합니다.</translation>
    </message>
    <message>
        <source>Program F as pitch times spindle speed, or the pitch in G95.</source>
        <translation>F를 피치 곱하기 주축 회전수로, 또는 G95에서 피치로 프로그램하십시오.</translation>
    </message>
    <message>
        <source>Tap not reversed</source>
        <translation>탭이 역회전하지 않음</translation>
    </message>
    <message>
        <source>The tap is retracted from a thread {} mm deep without reversing the spindle.</source>
        <translation>주축 역회전 없이 탭이 {} mm 깊이의 나사에서 빠져나옵니다.</translation>
    </message>
    <message>
        <source>Tap with G84, G74 or G33.1; turn this rule off for a reversing tap holder.</source>
        <translation>G84, G74 또는 G33.1로 탭핑하십시오. 자동 역전 탭 홀더라면 이 규칙을 끄십시오.</translation>
    </message>
    <message>
        <source>Tool differs from comment</source>
        <translation>공구가 주석과 다름</translation>
    </message>
    <message>
        <source>The comment describes T{} as ⌀ {} mm; the tool table has ⌀ {} mm.</source>
        <translation>주석은 T{}을(를) ⌀ {} mm로 설명하지만, 공구 테이블에는 ⌀ {} mm입니다.</translation>
    </message>
    <message>
        <source>Load the tool that the program was made for, or correct the comment.</source>
        <translation>프로그램에 맞는 공구를 불러오거나 주석을 고치십시오.</translation>
    </message>
    <message>
        <source>The comment describes T{} as “{}”; the tool table has “{}”.</source>
        <translation>주석은 T{}을(를) “{}”로 설명하지만, 공구 테이블에는 “{}”입니다.</translation>
    </message>
    <message>
        <source>Maximum feed rate and spindle speed of the machine</source>
        <translation>기계의 최대 이송 속도와 주축 회전수</translation>
    </message>
    <message>
        <source>Maximum spindle speed of the machine</source>
        <translation>기계의 최대 주축 회전수</translation>
    </message>
    <message>
        <source>&quot;{}&quot; of the machine must be a number from {} to {}.</source>
        <translation>기계의 &quot;{}&quot;은(는) {}에서 {} 사이의 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>A machine has no &quot;{}&quot;; it has {}.</source>
        <translation>기계에는 &quot;{}&quot;이(가) 없습니다. {}이(가) 있습니다.</translation>
    </message>
    <message>
        <source>Rapid traverse X/Y</source>
        <translation>급속 이송 X/Y</translation>
    </message>
    <message>
        <source>Speed of X and of Y at rapid.</source>
        <translation>X축과 Y축 각각의 급속 이송 속도입니다.</translation>
    </message>
    <message>
        <source>Rapid traverse Z</source>
        <translation>급속 이송 Z</translation>
    </message>
    <message>
        <source>Speed of Z at rapid.</source>
        <translation>Z축의 급속 이송 속도입니다.</translation>
    </message>
    <message>
        <source>Maximum feed rate</source>
        <translation>최대 이송 속도</translation>
    </message>
    <message>
        <source>The machine limits the feed rate to this, whatever F says.</source>
        <translation>F 값과 관계없이 기계는 이송 속도를 이 값으로 제한합니다.</translation>
    </message>
    <message>
        <source>Acceleration X, Y</source>
        <translation>가속도 X, Y</translation>
    </message>
    <message>
        <source>Acceleration of X and of Y.</source>
        <translation>X축과 Y축 각각의 가속도입니다.</translation>
    </message>
    <message>
        <source>Acceleration Z</source>
        <translation>가속도 Z</translation>
    </message>
    <message>
        <source>Acceleration of Z.</source>
        <translation>Z축의 가속도입니다.</translation>
    </message>
    <message>
        <source>Cornering tolerance</source>
        <translation>코너 공차</translation>
    </message>
    <message>
        <source>Largest deviation of a rounded corner; 0: exact stop at each corner.</source>
        <translation>둥글린 코너의 최대 편차입니다. 0: 코너마다 정위치 정지.</translation>
    </message>
    <message>
        <source>Tool change time, chip to chip.</source>
        <translation>공구 교환 시간(칩 투 칩)입니다.</translation>
    </message>
    <message>
        <source>There is not enough memory for the detail region.</source>
        <translation>상세 영역에 필요한 메모리가 부족합니다.</translation>
    </message>
    <message>
        <source>The detail region could not be cut: {}.</source>
        <translation>상세 영역을 절삭하지 못했습니다: {}.</translation>
    </message>
    <message>
        <source>The block that cut this point could not be found: {}.</source>
        <translation>이 지점을 절삭한 블록을 찾지 못했습니다: {}.</translation>
    </message>
    <message>
        <source>“{}” does not begin with a tool number from {} to {}, as in {}.</source>
        <translation>“{}”이(가) {}에서 {}까지의 공구 번호로 시작하지 않습니다. 예: {}.</translation>
    </message>
    <message>
        <source>A tool needs a number, a whole one from {} to {}.</source>
        <translation>공구에는 {}에서 {} 사이의 정수인 번호가 필요합니다.</translation>
    </message>
    <message>
        <source>The source of a tool is &quot;given&quot;, &quot;comment&quot; or &quot;assumed&quot;.</source>
        <translation>공구의 출처는 &quot;given&quot;, &quot;comment&quot;, &quot;assumed&quot; 중 하나여야 합니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; and the fields minX, minY, topZ cannot be used together; they are the same position.</source>
        <translation>&quot;{}&quot; 필드와 minX, minY, topZ 필드는 같은 위치를 나타내므로 함께 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a tool number; these are whole numbers from {} to {}.</source>
        <translation>&quot;{}&quot;은(는) 공구 번호가 아닙니다. 공구 번호는 {}에서 {}까지의 정수입니다.</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must be a list of whole numbers from 0 to {}.</source>
        <translation>&quot;{}&quot; 필드는 0에서 {} 사이의 정수 목록이어야 합니다.</translation>
    </message>
    <message>
        <source>spindle number</source>
        <translation>주축 번호</translation>
    </message>
    <message>
        <source>a Heidenhain conversational program</source>
        <translation>Heidenhain 대화형 프로그램</translation>
    </message>
    <message>
        <source>a Heidenhain DIN/ISO program</source>
        <translation>Heidenhain DIN/ISO 프로그램</translation>
    </message>
    <message>
        <source>a Siemens Sinumerik program</source>
        <translation>Siemens Sinumerik 프로그램</translation>
    </message>
    <message>
        <source>an Okuma OSP program</source>
        <translation>Okuma OSP 프로그램</translation>
    </message>
    <message>
        <source>a WinCNC program</source>
        <translation>WinCNC 프로그램</translation>
    </message>
    <message>
        <source>a ShopBot program</source>
        <translation>ShopBot 프로그램</translation>
    </message>
    <message>
        <source>a lathe program</source>
        <translation>선반 프로그램</translation>
    </message>
    <message>
        <source>a 3D printer program</source>
        <translation>3D 프린터 프로그램</translation>
    </message>
    <message>
        <source>an APT or CL data file</source>
        <translation>APT 또는 CL 데이터 파일</translation>
    </message>
    <message>
        <source>a Gerber file</source>
        <translation>Gerber 파일</translation>
    </message>
    <message>
        <source>an Excellon drill file</source>
        <translation>Excellon 드릴 파일</translation>
    </message>
    <message>
        <source>an HPGL plot file</source>
        <translation>HPGL 플롯 파일</translation>
    </message>
    <message>
        <source>a CAMotics project</source>
        <translation>CAMotics 프로젝트</translation>
    </message>
    <message>
        <source>a Proveout job</source>
        <translation>Proveout 작업</translation>
    </message>
    <message>
        <source>a JSON file</source>
        <translation>JSON 파일</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>SVG 도면</translation>
    </message>
    <message>
        <source>an HTML page</source>
        <translation>HTML 페이지</translation>
    </message>
    <message>
        <source>an XML file</source>
        <translation>XML 파일</translation>
    </message>
    <message>
        <source>an STL mesh</source>
        <translation>STL 메시</translation>
    </message>
    <message>
        <source>an OBJ mesh</source>
        <translation>OBJ 메시</translation>
    </message>
    <message>
        <source>a PLY mesh</source>
        <translation>PLY 메시</translation>
    </message>
    <message>
        <source>a STEP model</source>
        <translation>STEP 모델</translation>
    </message>
    <message>
        <source>a DXF drawing</source>
        <translation>DXF 도면</translation>
    </message>
    <message>
        <source>a PostScript file</source>
        <translation>PostScript 파일</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>PDF 문서</translation>
    </message>
    <message>
        <source>a rich text document</source>
        <translation>서식 있는 텍스트(RTF) 문서</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not an M code; write numbers from 0 to {}, for example 10, 11, 16.</source>
        <translation>&quot;{}&quot;은(는) M 코드가 아닙니다. 0에서 {} 사이의 숫자를 쓰십시오. 예: 10, 11, 16.</translation>
    </message>
    <message>
        <source>clamp of a rotary axis or pallet on</source>
        <translation>회전축 또는 팔레트 클램프 켜기</translation>
    </message>
    <message>
        <source>clamp of a rotary axis or pallet off</source>
        <translation>회전축 또는 팔레트 클램프 끄기</translation>
    </message>
    <message>
        <source>low spindle gear</source>
        <translation>주축 저속 기어</translation>
    </message>
    <message>
        <source>high spindle gear</source>
        <translation>주축 고속 기어</translation>
    </message>
    <message>
        <source>clamp of the B axis on</source>
        <translation>B축 클램프 켜기</translation>
    </message>
    <message>
        <source>clamp of the B axis off</source>
        <translation>B축 클램프 끄기</translation>
    </message>
    <message>
        <source>brake of the 4th axis on</source>
        <translation>제4축 브레이크 켜기</translation>
    </message>
    <message>
        <source>brake of the 4th axis off</source>
        <translation>제4축 브레이크 끄기</translation>
    </message>
    <message>
        <source>brake of the 5th axis on</source>
        <translation>제5축 브레이크 켜기</translation>
    </message>
    <message>
        <source>brake of the 5th axis off</source>
        <translation>제5축 브레이크 끄기</translation>
    </message>
    <message>
        <source>pallet unclamped, door open</source>
        <translation>팔레트 클램프 해제, 도어 열기</translation>
    </message>
    <message>
        <source>pallet clamped, door closed</source>
        <translation>팔레트 클램프, 도어 닫기</translation>
    </message>
    <message>
        <source>chip conveyor on</source>
        <translation>칩 컨베이어 켜기</translation>
    </message>
    <message>
        <source>chip conveyor off</source>
        <translation>칩 컨베이어 끄기</translation>
    </message>
    <message>
        <source>coolant nozzle one step on</source>
        <translation>절삭유 노즐 한 단계 앞으로</translation>
    </message>
    <message>
        <source>coolant nozzle one step back</source>
        <translation>절삭유 노즐 한 단계 뒤로</translation>
    </message>
    <message>
        <source>pallet part ready</source>
        <translation>팔레트 공작물 준비 완료</translation>
    </message>
    <message>
        <source>air through the tool on</source>
        <translation>공구 관통 에어 켜기</translation>
    </message>
    <message>
        <source>air through the tool off</source>
        <translation>공구 관통 에어 끄기</translation>
    </message>
    <message>
        <source>display off</source>
        <translation>화면 표시 끄기</translation>
    </message>
    <message>
        <source>display on</source>
        <translation>화면 표시 켜기</translation>
    </message>
    <message>
        <source>door open</source>
        <translation>도어 열기</translation>
    </message>
    <message>
        <source>door closed</source>
        <translation>도어 닫기</translation>
    </message>
    <message>
        <source>air jet on</source>
        <translation>에어 블로 켜기</translation>
    </message>
    <message>
        <source>air jet off</source>
        <translation>에어 블로 끄기</translation>
    </message>
    <message>
        <source>coolant through the spindle on</source>
        <translation>주축 관통 절삭유 켜기</translation>
    </message>
    <message>
        <source>coolant through the spindle off</source>
        <translation>주축 관통 절삭유 끄기</translation>
    </message>
    <message>
        <source>image shown on the display</source>
        <translation>화면에 그림 표시</translation>
    </message>
    <message>
        <source>image on the display closed</source>
        <translation>화면의 그림 닫기</translation>
    </message>
    <message>
        <source>spindle speed variation on</source>
        <translation>주축 속도 변동 켜기</translation>
    </message>
    <message>
        <source>spindle speed variation off</source>
        <translation>주축 속도 변동 끄기</translation>
    </message>
    <message>
        <source>mist extractor on</source>
        <translation>미스트 집진기 켜기</translation>
    </message>
    <message>
        <source>mist extractor off</source>
        <translation>미스트 집진기 끄기</translation>
    </message>
    <message>
        <source>This is {} (line {}: {}), which Proveout does not read.</source>
        <translation>이 파일은 {}이며({}번 줄: {}), Proveout이 읽지 않는 형식입니다.</translation>
    </message>
    <message>
        <source>This is {} (line {}: {}), not an NC program.</source>
        <translation>이 파일은 {}이며({}번 줄: {}), NC 프로그램이 아닙니다.</translation>
    </message>
    <message>
        <source>Open the program that the machine would run; if this is it, choose its dialect.</source>
        <translation>기계에서 실행할 프로그램을 여십시오. 이것이 그 프로그램이라면 제어기 방식을 선택하십시오.</translation>
    </message>
    <message>
        <source>If it moves no axis (a clamp, a door, air), add it to the ignored M codes of the setup; until then, results after this block are unverified.</source>
        <translation>축을 움직이지 않는 코드(클램프, 도어, 에어)라면 셋업의 무시할 M 코드에 추가하십시오. 그때까지 이 블록 뒤의 결과는 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>{} ({}) moves no axis and is ignored ({}×, line {}).</source>
        <translation>{}({})은(는) 축을 움직이지 않으므로 무시합니다({}회, {}번 줄).</translation>
    </message>
    <message>
        <source>The machine builder defines M codes; check this one where it matters.</source>
        <translation>M 코드의 의미는 기계 제조사가 정합니다. 이 코드가 중요한 곳에서는 확인하십시오.</translation>
    </message>
    <message>
        <source>{} is ignored because the setup lists it ({}×, line {}).</source>
        <translation>{}은(는) 셋업의 목록에 있으므로 무시합니다({}회, {}번 줄).</translation>
    </message>
    <message>
        <source>Remove it from the ignored M codes if it moves an axis.</source>
        <translation>축을 움직이는 코드라면 무시할 M 코드에서 제거하십시오.</translation>
    </message>
    <message>
        <source>{} ({}) is executed although the setup lists it as ignored.</source>
        <translation>{}({})은(는) 셋업의 무시 목록에 있지만 실행합니다.</translation>
    </message>
    <message>
        <source>Remove it from the ignored M codes: only codes without a known effect can be ignored.</source>
        <translation>무시할 M 코드에서 제거하십시오. 효과가 알려지지 않은 코드만 무시할 수 있습니다.</translation>
    </message>
    <message>
        <source>There is no spindle {}: the machine has one, $0.</source>
        <translation>주축 {}이(가) 없습니다. 기계의 주축은 $0 하나입니다.</translation>
    </message>
    <message>
        <source>Write $0, or leave the word out; this block is skipped.</source>
        <translation>$0을 쓰거나 워드를 삭제하십시오. 이 블록은 건너뜁니다.</translation>
    </message>
    <message>
        <source>Writing #5220 selects no work offset.</source>
        <translation>#5220에 값을 써도 공작물 좌표계가 선택되지 않습니다.</translation>
    </message>
    <message>
        <source>Select it with G54 to G59.3, which write #5220 themselves.</source>
        <translation>G54~G59.3으로 선택하십시오. 이 코드들이 #5220을 직접 씁니다.</translation>
    </message>
    <message>
        <source>G43.2 has both H and axis words.</source>
        <translation>G43.2에 H와 축 워드가 모두 있습니다.</translation>
    </message>
    <message>
        <source>Write two blocks; the offset in force is kept.</source>
        <translation>두 블록으로 나누어 쓰십시오. 유효한 보정이 유지됩니다.</translation>
    </message>
    <message>
        <source>LinuxCNC 2.9 mixes up the axes of a tapping cycle in {}: the tool feeds to another place than the hole bottom.</source>
        <translation>LinuxCNC 2.9는 {}에서 태핑 사이클의 축을 뒤바꿉니다. 공구가 구멍 바닥이 아닌 다른 곳으로 절삭 이송합니다.</translation>
    </message>
    <message>
        <source>Tap in G17, or use G33.1.</source>
        <translation>G17에서 태핑하거나 G33.1을 쓰십시오.</translation>
    </message>
    <message>
        <source>{} rotates the work offset while G92 or G52 is active: LinuxCNC then assumes a wrong tool position.</source>
        <translation>G92 또는 G52가 유효한 상태에서 {}이(가) 공작물 좌표계를 회전시킵니다. 그 뒤 LinuxCNC는 공구 위치를 잘못 인식합니다.</translation>
    </message>
    <message>
        <source>Cancel the shift with G92.1 first, and set it again afterwards.</source>
        <translation>먼저 G92.1로 좌표계 이동을 취소하고, 그 뒤에 다시 설정하십시오.</translation>
    </message>
    <message>
        <source>The control assumes another tool position than the real one at the start of this arc.</source>
        <translation>이 원호의 시작점에서 제어기가 인식하는 공구 위치가 실제 위치와 다릅니다.</translation>
    </message>
    <message>
        <source>Program a straight move before the arc; the arc is skipped.</source>
        <translation>원호 앞에 직선 이동을 지령하십시오. 이 원호는 건너뜁니다.</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>PNG 그림</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>JPEG 그림</translation>
    </message>
    <message>
        <source>a GIF picture</source>
        <translation>GIF 그림</translation>
    </message>
    <message>
        <source>a ZIP archive, as 3MF, FreeCAD and office files are</source>
        <translation>ZIP 압축 파일(3MF, FreeCAD, 오피스 파일 등)</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <translation>gzip 압축 파일</translation>
    </message>
    <message>
        <source>a 7z archive</source>
        <translation>7z 압축 파일</translation>
    </message>
    <message>
        <source>an office or CAD document</source>
        <translation>오피스 또는 CAD 문서</translation>
    </message>
    <message>
        <source>an executable file</source>
        <translation>실행 파일</translation>
    </message>
    <message>
        <source>This is {}, not an NC program.</source>
        <translation>이 파일은 {}이며, NC 프로그램이 아닙니다.</translation>
    </message>
    <message>
        <source>The grid spacing of {} mm is too coarse for T{} (⌀{} mm): it has only {} points across it.</source>
        <translation>격자 간격 {} mm는 T{}(⌀{} mm)에 너무 큽니다. 커터 지름에 걸치는 점이 {}개뿐입니다.</translation>
    </message>
    <message>
        <source>Choose a finer grid, or the automatic one; see details with View, Magnifier, or in a smaller stock.</source>
        <translation>더 작은 격자 간격이나 자동을 선택하십시오. 세부는 보기의 돋보기나 더 작은 소재에서 확인하십시오.</translation>
    </message>
    <message>
        <source>See details with View, Magnifier, or in a smaller stock, or enter a finer grid spacing.</source>
        <translation>세부는 보기의 돋보기나 더 작은 소재에서 확인하거나, 더 작은 격자 간격을 입력하십시오.</translation>
    </message>
    <message>
        <source>Confirm the sizes of the tool in the tool table, or correct them.</source>
        <translation>공구 테이블에서 공구의 치수를 확인하거나 고치십시오.</translation>
    </message>
    <message>
        <source>Rapid move cuts stock ({} mm deep) with the unconfirmed tool T{}.</source>
        <translation>급속 이송이 소재를 절삭합니다(깊이 {} mm, 확인되지 않은 공구 T{}).</translation>
    </message>
    <message>
        <source>The cut is {} mm deep, beyond the flutes of the unconfirmed tool T{}.</source>
        <translation>절삭 깊이가 {} mm로, 확인되지 않은 공구 T{}의 날 길이를 넘습니다.</translation>
    </message>
    <message>
        <source>{} mm of stock meet the neck of the unconfirmed tool T{}.</source>
        <translation>소재 {} mm가 확인되지 않은 공구 T{}의 목에 닿습니다.</translation>
    </message>
    <message>
        <source>T{} is read from a comment (⌀ {} mm {}); it is not confirmed.</source>
        <translation>T{}은(는) 주석에서 읽었으며(⌀ {} mm {}) 확인되지 않았습니다.</translation>
    </message>
    <message>
        <source>T{} is read from a comment (⌀ {} mm {}; assumed: {}); it is not confirmed.</source>
        <translation>T{}은(는) 주석에서 읽었으며(⌀ {} mm {}; 가정한 값: {}) 확인되지 않았습니다.</translation>
    </message>
    <message>
        <source>The sizes of T{} are assumed (⌀ {} mm {}); they are not confirmed.</source>
        <translation>T{}의 치수는 가정한 값이며(⌀ {} mm {}) 확인되지 않았습니다.</translation>
    </message>
    <message>
        <source>The program cuts before it calls a tool; T{} is assumed to be in the spindle.</source>
        <translation>공구를 호출하기 전에 절삭합니다. T{}이(가) 주축에 있다고 가정합니다.</translation>
    </message>
    <message>
        <source>Set the tool at start in the setup if this is the right one.</source>
        <translation>이 공구가 맞으면 셋업에서 시작 공구로 지정하십시오.</translation>
    </message>
    <message>
        <source>T{} is not in the tool table; its moves are not simulated.</source>
        <translation>T{}이(가) 공구 테이블에 없어 그 이동을 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>Define it in the tool table.</source>
        <translation>공구 테이블에 정의하십시오.</translation>
    </message>
    <message>
        <source>The program cuts before it calls a tool; moves are not simulated until it does.</source>
        <translation>공구를 호출하기 전에 절삭합니다. 공구를 호출할 때까지 이동을 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>Set the tool at start in the setup, or program T and M6 before the first cut.</source>
        <translation>셋업에서 시작 공구를 지정하거나 첫 절삭 전에 T와 M6을 지령하십시오.</translation>
    </message>
    <message>
        <source>T{} leaves the spindle empty; its moves are not simulated.</source>
        <translation>T{}은(는) 주축을 비우므로 그 이동을 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>Define T0 in the tool table if it is a cutter.</source>
        <translation>T0이 커터라면 공구 테이블에 정의하십시오.</translation>
    </message>
    <message>
        <source>Min X</source>
        <translation>최소 X</translation>
    </message>
    <message>
        <source>Program coordinate of the left side of the stock.</source>
        <translation>소재 왼쪽 면의 프로그램 좌표입니다.</translation>
    </message>
    <message>
        <source>Min Y</source>
        <translation>최소 Y</translation>
    </message>
    <message>
        <source>Program coordinate of the front side of the stock.</source>
        <translation>소재 앞쪽 면의 프로그램 좌표입니다.</translation>
    </message>
    <message>
        <source>Top Z</source>
        <translation>윗면 Z</translation>
    </message>
    <message>
        <source>Program coordinate of the top of the stock.</source>
        <translation>소재 윗면의 프로그램 좌표입니다.</translation>
    </message>
    <message>
        <source>Grid spacing</source>
        <translation>격자 간격</translation>
    </message>
    <message>
        <source>Distance between the points of the z-map; adjusted so that it divides the stock exactly.</source>
        <translation>Z맵 점 사이의 거리입니다. 소재를 정확히 나누도록 조정됩니다.</translation>
    </message>
    <message>
        <source>Start position</source>
        <translation>시작 위치</translation>
    </message>
    <message>
        <source>Program coordinates of the tool tip before the first block; unknown if not set.</source>
        <translation>첫 블록 전 공구 선단의 프로그램 좌표입니다. 설정하지 않으면 위치를 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Tool at start</source>
        <translation>시작 공구</translation>
    </message>
    <message>
        <source>Tool in the spindle before the first tool change; 0 is an empty spindle, or T0 of the tool table.</source>
        <translation>첫 공구 교환 전에 주축에 있는 공구입니다. 0은 빈 주축 또는 공구 테이블의 T0입니다.</translation>
    </message>
    <message>
        <source>Check the size and position of the stock, and the work offset: the position of the stock is that of its top, not its bottom.</source>
        <translation>소재의 크기와 위치, 공작물 좌표계를 확인하십시오. 소재의 위치는 바닥이 아니라 윗면의 위치입니다.</translation>
    </message>
    <message>
        <source>The program never cuts the stock: its cutting moves are within {}, the stock within {}.</source>
        <translation>프로그램이 소재를 전혀 절삭하지 않습니다. 절삭 이송의 범위는 {}, 소재의 범위는 {}입니다.</translation>
    </message>
    <message>
        <source>Cutting moves extend {} mm beyond the stock in {}, where it measures {} mm.</source>
        <translation>절삭 이송이 소재를 {} mm 벗어납니다({} 방향, 소재 크기 {} mm).</translation>
    </message>
    <message>
        <source>The stock has no file yet; nothing is simulated.</source>
        <translation>소재 파일이 아직 지정되지 않아 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>The stock cannot be made from {}; nothing is simulated.</source>
        <translation>{}(으)로 소재를 만들 수 없어 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>Choose the file of the stock, or another shape.</source>
        <translation>소재 파일이나 다른 형상을 선택하십시오.</translation>
    </message>
    <message>
        <source>Unsaved changes are no longer backed up: {}.</source>
        <translation>저장하지 않은 변경이 더 이상 백업되지 않습니다: {}.</translation>
    </message>
    <message>
        <source>Save under another name (File &gt; Save As).</source>
        <translation>다른 이름으로 저장하십시오(파일 &gt; 다른 이름으로 저장).</translation>
    </message>
    <message>
        <source>The file has changed on disk; it was not overwritten.</source>
        <translation>디스크의 파일이 변경되어 덮어쓰지 않았습니다.</translation>
    </message>
    <message>
        <source>The backup of this session is damaged.</source>
        <translation>이 세션의 백업이 손상되었습니다.</translation>
    </message>
    <message>
        <source>{} of {} facets are duplicates of another facet.</source>
        <translation>{2}개의 면 중 {1}개는 다른 면과 중복됩니다.</translation>
    </message>
    <message>
        <source>Export the part again as one closed solid.</source>
        <translation>공작물을 하나의 닫힌 솔리드로 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>The mesh is not closed: {} edges belong to only one facet.</source>
        <translation>메시가 닫혀 있지 않습니다. 모서리 {}개가 면 하나에만 속합니다.</translation>
    </message>
    <message>
        <source>The mesh is not manifold: {} edges belong to more than two facets.</source>
        <translation>메시가 다양체가 아닙니다. 모서리 {}개가 면 세 개 이상에 속합니다.</translation>
    </message>
    <message>
        <source>The winding of the facets is inconsistent: it changes at {} edges.</source>
        <translation>면의 정점 순서가 일관되지 않습니다. 모서리 {}개에서 순서가 바뀝니다.</translation>
    </message>
    <message>
        <source>The mesh is inside out: {} of {} facets face inwards; they are taken as facing outwards.</source>
        <translation>메시의 안팎이 뒤집혀 있습니다. {2}개의 면 중 {1}개가 안쪽을 향하며, 바깥쪽을 향하는 것으로 간주합니다.</translation>
    </message>
    <message>
        <source>The mesh is only {} mm in size; in metres it would be {} mm.</source>
        <translation>메시 크기가 {} mm에 불과합니다. 단위가 미터라면 {} mm입니다.</translation>
    </message>
    <message>
        <source>The mesh is {} mm in size; in micrometres it would be {} mm.</source>
        <translation>메시 크기가 {} mm입니다. 단위가 마이크로미터라면 {} mm입니다.</translation>
    </message>
    <message>
        <source>Export the part in millimetres; STL files have no unit.</source>
        <translation>공작물을 밀리미터 단위로 내보내십시오. STL 파일에는 단위가 없습니다.</translation>
    </message>
    <message>
        <source>The program calls no tool; T{} is assumed to be in the spindle.</source>
        <translation>프로그램이 공구를 호출하지 않습니다. T{}이(가) 주축에 있다고 가정합니다.</translation>
    </message>
    <message>
        <source>The program calls no tool; its moves are not simulated.</source>
        <translation>프로그램이 공구를 호출하지 않습니다. 이동을 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>The stock file has changed on disk; the simulation still uses the version read before.</source>
        <translation>디스크에서 소재 파일이 변경되었습니다. 시뮬레이션은 이전에 읽은 버전을 사용합니다.</translation>
    </message>
    <message>
        <source>Reload the stock in the Setup panel, or keep the current version.</source>
        <translation>셋업 패널에서 소재를 다시 읽거나 현재 버전을 유지하십시오.</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>형상</translation>
    </message>
    <message>
        <source>{} ({}) moves no axis and is ignored ({}×, lines {}).</source>
        <translation>{}({})은(는) 축을 움직이지 않으므로 무시합니다({}회, {}번 줄).</translation>
    </message>
    <message>
        <source>{} is ignored because the setup lists it ({}×, lines {}).</source>
        <translation>{}은(는) 셋업의 목록에 있으므로 무시합니다({}회, {}번 줄).</translation>
    </message>
    <message>
        <source>Unexpected character</source>
        <translation>잘못된 문자</translation>
    </message>
    <message>
        <source>Word without a value</source>
        <translation>값이 없는 워드</translation>
    </message>
    <message>
        <source>Number with two signs</source>
        <translation>부호가 두 개인 숫자</translation>
    </message>
    <message>
        <source>Number with two points</source>
        <translation>소수점이 두 개인 숫자</translation>
    </message>
    <message>
        <source>Number out of range</source>
        <translation>범위를 벗어난 숫자</translation>
    </message>
    <message>
        <source>Comment not closed</source>
        <translation>닫히지 않은 주석</translation>
    </message>
    <message>
        <source>Nested comment</source>
        <translation>중첩된 주석</translation>
    </message>
    <message>
        <source>Duplicate word</source>
        <translation>중복된 워드</translation>
    </message>
    <message>
        <source>Duplicate word, last used</source>
        <translation>중복된 워드, 마지막 값 사용</translation>
    </message>
    <message>
        <source>Too many codes in block</source>
        <translation>블록의 코드가 너무 많음</translation>
    </message>
    <message>
        <source>N word not first</source>
        <translation>블록 앞에 있지 않은 N 워드</translation>
    </message>
    <message>
        <source>Negative block number</source>
        <translation>음수 블록 번호</translation>
    </message>
    <message>
        <source>Block number too long</source>
        <translation>너무 긴 블록 번호</translation>
    </message>
    <message>
        <source>&quot;%&quot; not alone</source>
        <translation>단독 줄이 아닌 &quot;%&quot;</translation>
    </message>
    <message>
        <source>Line too long</source>
        <translation>너무 긴 줄</translation>
    </message>
    <message>
        <source>Control codes skipped</source>
        <translation>제어 문자 건너뜀</translation>
    </message>
    <message>
        <source>Byte order mark</source>
        <translation>바이트 순서 표시</translation>
    </message>
    <message>
        <source>CR line end</source>
        <translation>CR 줄 끝</translation>
    </message>
    <message>
        <source>No decimal point</source>
        <translation>소수점 없음</translation>
    </message>
    <message>
        <source>Expression nested too deeply</source>
        <translation>수식의 중첩이 너무 깊음</translation>
    </message>
    <message>
        <source>Brackets nested too deeply</source>
        <translation>괄호의 중첩이 너무 깊음</translation>
    </message>
    <message>
        <source>Parameter not set</source>
        <translation>설정되지 않은 파라미터</translation>
    </message>
    <message>
        <source>Position not readable</source>
        <translation>읽을 수 없는 위치</translation>
    </message>
    <message>
        <source>Parameter number not whole</source>
        <translation>정수가 아닌 파라미터 번호</translation>
    </message>
    <message>
        <source>Unknown parameter number</source>
        <translation>알 수 없는 파라미터 번호</translation>
    </message>
    <message>
        <source>Read-only parameter</source>
        <translation>읽기 전용 파라미터</translation>
    </message>
    <message>
        <source>Name not closed</source>
        <translation>닫히지 않은 이름</translation>
    </message>
    <message>
        <source>Empty name</source>
        <translation>빈 이름</translation>
    </message>
    <message>
        <source>Name too long</source>
        <translation>너무 긴 이름</translation>
    </message>
    <message>
        <source>Too many named parameters</source>
        <translation>이름 있는 파라미터가 너무 많음</translation>
    </message>
    <message>
        <source>Bracket not closed</source>
        <translation>닫히지 않은 괄호</translation>
    </message>
    <message>
        <source>Brackets missing</source>
        <translation>괄호 없음</translation>
    </message>
    <message>
        <source>Operator missing</source>
        <translation>연산자 없음</translation>
    </message>
    <message>
        <source>Expression without a result</source>
        <translation>결과가 없는 수식</translation>
    </message>
    <message>
        <source>Second argument missing</source>
        <translation>두 번째 인수 없음</translation>
    </message>
    <message>
        <source>EXISTS without a name</source>
        <translation>이름이 없는 EXISTS</translation>
    </message>
    <message>
        <source>Incomplete assignment</source>
        <translation>불완전한 대입</translation>
    </message>
    <message>
        <source>Undocumented modal variable</source>
        <translation>문서에 없는 모달 변수</translation>
    </message>
    <message>
        <source>Machine-dependent variable</source>
        <translation>기계에 따라 다른 변수</translation>
    </message>
    <message>
        <source>Variable assumed to be 0</source>
        <translation>변수를 0으로 가정</translation>
    </message>
    <message>
        <source>Position unknown</source>
        <translation>알 수 없는 위치</translation>
    </message>
    <message>
        <source>#5220 written</source>
        <translation>#5220에 쓰기</translation>
    </message>
    <message>
        <source>Invalid O number</source>
        <translation>잘못된 O 번호</translation>
    </message>
    <message>
        <source>Unknown O-word keyword</source>
        <translation>알 수 없는 O 워드 키워드</translation>
    </message>
    <message>
        <source>O word not first</source>
        <translation>블록 앞에 있지 않은 O 워드</translation>
    </message>
    <message>
        <source>Text after O word</source>
        <translation>O 워드 뒤의 텍스트</translation>
    </message>
    <message>
        <source>Unmatched O word</source>
        <translation>짝이 없는 O 워드</translation>
    </message>
    <message>
        <source>Duplicate O label</source>
        <translation>중복된 O 레이블</translation>
    </message>
    <message>
        <source>Continue in a do loop</source>
        <translation>do 루프 안의 continue</translation>
    </message>
    <message>
        <source>Nested subprogram</source>
        <translation>중첩된 서브프로그램</translation>
    </message>
    <message>
        <source>Condition missing</source>
        <translation>조건 없음</translation>
    </message>
    <message>
        <source>Subprogram not found</source>
        <translation>서브프로그램을 찾을 수 없음</translation>
    </message>
    <message>
        <source>Subprogram outside its folders</source>
        <translation>폴더 밖의 서브프로그램</translation>
    </message>
    <message>
        <source>Subprogram not readable</source>
        <translation>읽을 수 없는 서브프로그램</translation>
    </message>
    <message>
        <source>Subprogram not closed</source>
        <translation>닫히지 않은 서브프로그램</translation>
    </message>
    <message>
        <source>Calls nested too deeply</source>
        <translation>호출의 중첩이 너무 깊음</translation>
    </message>
    <message>
        <source>Too many arguments</source>
        <translation>인수가 너무 많음</translation>
    </message>
    <message>
        <source>Return outside a subprogram</source>
        <translation>서브프로그램 밖의 복귀</translation>
    </message>
    <message>
        <source>Main program repeats</source>
        <translation>메인 프로그램 반복</translation>
    </message>
    <message>
        <source>M98 with L0</source>
        <translation>L0이 있는 M98</translation>
    </message>
    <message>
        <source>Call not first</source>
        <translation>블록 앞에 있지 않은 호출</translation>
    </message>
    <message>
        <source>M99 not alone</source>
        <translation>단독이 아닌 M99</translation>
    </message>
    <message>
        <source>Too many repeated messages</source>
        <translation>반복된 메시지가 너무 많음</translation>
    </message>
    <message>
        <source>Too many repeated blocks</source>
        <translation>반복된 블록이 너무 많음</translation>
    </message>
    <message>
        <source>Loop without motion</source>
        <translation>이동이 없는 루프</translation>
    </message>
    <message>
        <source>Endless loop</source>
        <translation>무한 루프</translation>
    </message>
    <message>
        <source>Too many repeats</source>
        <translation>반복 횟수가 너무 많음</translation>
    </message>
    <message>
        <source>Too many motions in block</source>
        <translation>블록의 이동이 너무 많음</translation>
    </message>
    <message>
        <source>Invalid jump target</source>
        <translation>잘못된 점프 대상</translation>
    </message>
    <message>
        <source>Jump target not found</source>
        <translation>점프 대상을 찾을 수 없음</translation>
    </message>
    <message>
        <source>Duplicate block number</source>
        <translation>중복된 블록 번호</translation>
    </message>
    <message>
        <source>Incomplete statement</source>
        <translation>불완전한 매크로 문</translation>
    </message>
    <message>
        <source>Statement not first</source>
        <translation>블록 앞에 있지 않은 매크로 문</translation>
    </message>
    <message>
        <source>Unmatched loop</source>
        <translation>짝이 없는 루프</translation>
    </message>
    <message>
        <source>Program alarm</source>
        <translation>프로그램 알람</translation>
    </message>
    <message>
        <source>Program repeats</source>
        <translation>프로그램 반복</translation>
    </message>
    <message>
        <source>Unsupported encoding</source>
        <translation>지원하지 않는 인코딩</translation>
    </message>
    <message>
        <source>Binary file</source>
        <translation>바이너리 파일</translation>
    </message>
    <message>
        <source>Invalid M code list</source>
        <translation>잘못된 M 코드 목록</translation>
    </message>
    <message>
        <source>Dialect detected</source>
        <translation>제어기 방식 감지</translation>
    </message>
    <message>
        <source>Unsupported dialect</source>
        <translation>지원하지 않는 제어기 방식</translation>
    </message>
    <message>
        <source>Not an NC program</source>
        <translation>NC 프로그램이 아님</translation>
    </message>
    <message>
        <source>Text before &quot;%&quot;</source>
        <translation>&quot;%&quot; 앞의 텍스트</translation>
    </message>
    <message>
        <source>Opening &quot;%&quot; missing</source>
        <translation>시작 &quot;%&quot; 없음</translation>
    </message>
    <message>
        <source>&quot;%&quot; inside the program</source>
        <translation>프로그램 안의 &quot;%&quot;</translation>
    </message>
    <message>
        <source>Text after &quot;%&quot;</source>
        <translation>&quot;%&quot; 뒤의 텍스트</translation>
    </message>
    <message>
        <source>Blocks after program end</source>
        <translation>프로그램 끝 뒤의 블록</translation>
    </message>
    <message>
        <source>Program end missing</source>
        <translation>프로그램 끝 없음</translation>
    </message>
    <message>
        <source>No motion</source>
        <translation>이동 없음</translation>
    </message>
    <message>
        <source>Too many motions</source>
        <translation>이동이 너무 많음</translation>
    </message>
    <message>
        <source>Program too large</source>
        <translation>너무 큰 프로그램</translation>
    </message>
    <message>
        <source>Too many events</source>
        <translation>이벤트가 너무 많음</translation>
    </message>
    <message>
        <source>Interpretation stopped</source>
        <translation>해석 중단</translation>
    </message>
    <message>
        <source>Still reading</source>
        <translation>읽는 중</translation>
    </message>
    <message>
        <source>Unknown code</source>
        <translation>알 수 없는 코드</translation>
    </message>
    <message>
        <source>Code ignored</source>
        <translation>무시된 코드</translation>
    </message>
    <message>
        <source>Listed code executed</source>
        <translation>목록의 코드가 실행됨</translation>
    </message>
    <message>
        <source>Unsupported code</source>
        <translation>지원하지 않는 코드</translation>
    </message>
    <message>
        <source>Conflicting codes</source>
        <translation>충돌하는 코드</translation>
    </message>
    <message>
        <source>Conflicting codes, last used</source>
        <translation>충돌하는 코드, 마지막 코드 사용</translation>
    </message>
    <message>
        <source>Too many M codes</source>
        <translation>M 코드가 너무 많음</translation>
    </message>
    <message>
        <source>Axis ignored</source>
        <translation>무시된 축</translation>
    </message>
    <message>
        <source>Unused word</source>
        <translation>사용되지 않는 워드</translation>
    </message>
    <message>
        <source>Word ignored</source>
        <translation>무시된 워드</translation>
    </message>
    <message>
        <source>No such spindle</source>
        <translation>없는 주축</translation>
    </message>
    <message>
        <source>No motion code active</source>
        <translation>유효한 이동 코드 없음</translation>
    </message>
    <message>
        <source>Axis word with G80</source>
        <translation>G80과 축 워드</translation>
    </message>
    <message>
        <source>Rapid after G80</source>
        <translation>G80 뒤의 급속 이송</translation>
    </message>
    <message>
        <source>Word missing</source>
        <translation>워드 없음</translation>
    </message>
    <message>
        <source>Negative number</source>
        <translation>음수</translation>
    </message>
    <message>
        <source>Not a whole number</source>
        <translation>정수가 아님</translation>
    </message>
    <message>
        <source>Axis words used twice</source>
        <translation>축 워드의 이중 사용</translation>
    </message>
    <message>
        <source>No modal state saved</source>
        <translation>저장된 모달 상태 없음</translation>
    </message>
    <message>
        <source>M72 not alone</source>
        <translation>단독이 아닌 M72</translation>
    </message>
    <message>
        <source>No tool selected</source>
        <translation>선택된 공구 없음</translation>
    </message>
    <message>
        <source>G43.2 with H and axes</source>
        <translation>H와 축이 있는 G43.2</translation>
    </message>
    <message>
        <source>Unsupported G10</source>
        <translation>지원하지 않는 G10</translation>
    </message>
    <message>
        <source>Tool number unknown</source>
        <translation>알 수 없는 공구 번호</translation>
    </message>
    <message>
        <source>G53 without G0 or G1</source>
        <translation>G0, G1이 없는 G53</translation>
    </message>
    <message>
        <source>Polar and Cartesian words</source>
        <translation>극좌표와 직교좌표 혼용</translation>
    </message>
    <message>
        <source>Polar angle undefined</source>
        <translation>정의되지 않은 극각도</translation>
    </message>
    <message>
        <source>G53 with polar words</source>
        <translation>극좌표 워드가 있는 G53</translation>
    </message>
    <message>
        <source>G53 in incremental mode</source>
        <translation>증분 지령의 G53</translation>
    </message>
    <message>
        <source>G53 ignored</source>
        <translation>무시된 G53</translation>
    </message>
    <message>
        <source>Machine zero unknown</source>
        <translation>알 수 없는 기계 원점</translation>
    </message>
    <message>
        <source>Arc outside rotated plane</source>
        <translation>회전 평면 밖의 원호</translation>
    </message>
    <message>
        <source>Arc scaled unevenly</source>
        <translation>축마다 다르게 스케일링된 원호</translation>
    </message>
    <message>
        <source>Scale factor 0</source>
        <translation>스케일링 배율 0</translation>
    </message>
    <message>
        <source>Transformation order</source>
        <translation>좌표 변환의 순서</translation>
    </message>
    <message>
        <source>Transformation centre unknown</source>
        <translation>변환 중심을 알 수 없음</translation>
    </message>
    <message>
        <source>Rotation start ambiguous</source>
        <translation>모호한 회전 시작</translation>
    </message>
    <message>
        <source>Rotation angle ambiguous</source>
        <translation>모호한 회전 각도</translation>
    </message>
    <message>
        <source>Reference return in cycle</source>
        <translation>사이클 중 원점 복귀</translation>
    </message>
    <message>
        <source>Intermediate point unknown</source>
        <translation>알 수 없는 중간점</translation>
    </message>
    <message>
        <source>Homing cycle</source>
        <translation>원점 복귀</translation>
    </message>
    <message>
        <source>Control data skipped</source>
        <translation>건너뛴 제어기 데이터</translation>
    </message>
    <message>
        <source>Offset register unknown</source>
        <translation>알 수 없는 보정 번호</translation>
    </message>
    <message>
        <source>Length offset without Z</source>
        <translation>Z 없는 길이 보정</translation>
    </message>
    <message>
        <source>Rotation with G92 active</source>
        <translation>G92 유효 중의 회전</translation>
    </message>
    <message>
        <source>Cycle word missing</source>
        <translation>사이클 워드 없음</translation>
    </message>
    <message>
        <source>Cycle without a position</source>
        <translation>위치가 없는 사이클</translation>
    </message>
    <message>
        <source>Cycle with inverse time</source>
        <translation>역시간 이송의 사이클</translation>
    </message>
    <message>
        <source>R plane below hole bottom</source>
        <translation>구멍 바닥 아래의 R점</translation>
    </message>
    <message>
        <source>Invalid peck depth</source>
        <translation>잘못된 1회 절입량</translation>
    </message>
    <message>
        <source>Peck depth missing</source>
        <translation>1회 절입량 없음</translation>
    </message>
    <message>
        <source>Spindle stopped in cycle</source>
        <translation>사이클 중 주축 정지</translation>
    </message>
    <message>
        <source>Back boring not verified</source>
        <translation>백 보링 미검증</translation>
    </message>
    <message>
        <source>Invalid back boring depth</source>
        <translation>잘못된 백 보링 깊이</translation>
    </message>
    <message>
        <source>Back boring with G99</source>
        <translation>G99의 백 보링</translation>
    </message>
    <message>
        <source>Tapping feeds off the hole</source>
        <translation>구멍을 벗어난 태핑</translation>
    </message>
    <message>
        <source>Fine boring not verified</source>
        <translation>정밀 보링 미검증</translation>
    </message>
    <message>
        <source>Manual retract</source>
        <translation>수동 후퇴</translation>
    </message>
    <message>
        <source>Initial level unknown</source>
        <translation>알 수 없는 초기점</translation>
    </message>
    <message>
        <source>Tapping with stopped spindle</source>
        <translation>주축 정지 중의 태핑</translation>
    </message>
    <message>
        <source>Cycle only stored</source>
        <translation>저장만 된 사이클</translation>
    </message>
    <message>
        <source>Pattern without a cycle</source>
        <translation>사이클이 없는 패턴</translation>
    </message>
    <message>
        <source>First hole assumed</source>
        <translation>가정된 첫 구멍</translation>
    </message>
    <message>
        <source>Pocket path assumed</source>
        <translation>가정된 포켓 경로</translation>
    </message>
    <message>
        <source>Invalid pocket size</source>
        <translation>잘못된 포켓 크기</translation>
    </message>
    <message>
        <source>F missing with G93</source>
        <translation>G93에 F 없음</translation>
    </message>
    <message>
        <source>Feed per revolution without spindle</source>
        <translation>주축 없는 회전당 이송</translation>
    </message>
    <message>
        <source>Feed before unit change</source>
        <translation>단위 변경 전의 이송 속도</translation>
    </message>
    <message>
        <source>Diameter mode</source>
        <translation>지름 지령</translation>
    </message>
    <message>
        <source>Surface speed at limit</source>
        <translation>한계값에서의 주속 일정 제어</translation>
    </message>
    <message>
        <source>Spindle speed unknown</source>
        <translation>알 수 없는 주축 회전수</translation>
    </message>
    <message>
        <source>Invalid pitch</source>
        <translation>잘못된 피치</translation>
    </message>
    <message>
        <source>F with synchronised motion</source>
        <translation>동기 이동의 F</translation>
    </message>
    <message>
        <source>Synchronised motion, spindle stopped</source>
        <translation>주축 정지 중의 동기 이동</translation>
    </message>
    <message>
        <source>Feed rate missing</source>
        <translation>이송 속도 없음</translation>
    </message>
    <message>
        <source>Mist coolant optional</source>
        <translation>미스트 절삭유(선택 사양)</translation>
    </message>
    <message>
        <source>Dwell unit ambiguous</source>
        <translation>모호한 드웰 단위</translation>
    </message>
    <message>
        <source>Target too far</source>
        <translation>너무 먼 목표점</translation>
    </message>
    <message>
        <source>Start position unknown</source>
        <translation>알 수 없는 시작 위치</translation>
    </message>
    <message>
        <source>Axis never positioned</source>
        <translation>위치가 정해지지 않은 축</translation>
    </message>
    <message>
        <source>Incremental from unknown position</source>
        <translation>알 수 없는 위치에서의 증분 이동</translation>
    </message>
    <message>
        <source>One-sided positioning</source>
        <translation>한 방향 위치 결정</translation>
    </message>
    <message>
        <source>Arc without centre</source>
        <translation>중심이 없는 원호</translation>
    </message>
    <message>
        <source>Arc centre incomplete</source>
        <translation>불완전한 원호 중심</translation>
    </message>
    <message>
        <source>Arc with R and centre</source>
        <translation>R과 중심이 있는 원호</translation>
    </message>
    <message>
        <source>Arc word outside plane</source>
        <translation>평면 밖의 원호 워드</translation>
    </message>
    <message>
        <source>Arc radius zero</source>
        <translation>반경 0인 원호</translation>
    </message>
    <message>
        <source>Arc end radius mismatch</source>
        <translation>원호 반경 불일치</translation>
    </message>
    <message>
        <source>Full circle with R</source>
        <translation>R로 지정한 완전한 원</translation>
    </message>
    <message>
        <source>Arc radius too small</source>
        <translation>너무 작은 원호 반경</translation>
    </message>
    <message>
        <source>Arc centre ignored</source>
        <translation>무시된 원호 중심</translation>
    </message>
    <message>
        <source>Arc without motion</source>
        <translation>움직이지 않는 원호</translation>
    </message>
    <message>
        <source>Arc becomes a line</source>
        <translation>직선이 되는 원호</translation>
    </message>
    <message>
        <source>Arc radius too large</source>
        <translation>너무 큰 원호 반경</translation>
    </message>
    <message>
        <source>Arc too long</source>
        <translation>너무 긴 원호</translation>
    </message>
    <message>
        <source>Invalid number of turns</source>
        <translation>잘못된 회전 횟수</translation>
    </message>
    <message>
        <source>Arc start mismatch</source>
        <translation>원호 시작점 불일치</translation>
    </message>
    <message>
        <source>Arc word ignored</source>
        <translation>무시된 원호 워드</translation>
    </message>
    <message>
        <source>Arc end point missing</source>
        <translation>원호 끝점 없음</translation>
    </message>
    <message>
        <source>Arc centre ambiguous</source>
        <translation>모호한 원호 중심</translation>
    </message>
    <message>
        <source>Polar centre ambiguous</source>
        <translation>모호한 극점</translation>
    </message>
    <message>
        <source>Polar motion undocumented</source>
        <translation>문서에 없는 극좌표 이동</translation>
    </message>
    <message>
        <source>Radius scaling assumed</source>
        <translation>가정된 반경 스케일링</translation>
    </message>
    <message>
        <source>XY plane only</source>
        <translation>XY 평면 전용</translation>
    </message>
    <message>
        <source>M66 with P and E</source>
        <translation>P와 E가 있는 M66</translation>
    </message>
    <message>
        <source>M66 wait mode</source>
        <translation>M66 대기 모드</translation>
    </message>
    <message>
        <source>Input value assumed</source>
        <translation>가정된 입력값</translation>
    </message>
    <message>
        <source>Input value used</source>
        <translation>사용된 입력값</translation>
    </message>
    <message>
        <source>Probing with G95</source>
        <translation>G95의 프로빙</translation>
    </message>
    <message>
        <source>Probing motion too short</source>
        <translation>너무 짧은 프로빙 이동</translation>
    </message>
    <message>
        <source>Skip signal unknown</source>
        <translation>알 수 없는 스킵 신호</translation>
    </message>
    <message>
        <source>Probe contact unknown</source>
        <translation>알 수 없는 프로브 접촉</translation>
    </message>
    <message>
        <source>Probe contact assumed</source>
        <translation>가정된 프로브 접촉</translation>
    </message>
    <message>
        <source>Probe release assumed</source>
        <translation>가정된 프로브 이탈</translation>
    </message>
    <message>
        <source>Probe result used</source>
        <translation>사용된 프로빙 결과</translation>
    </message>
    <message>
        <source>Probe without contact</source>
        <translation>접촉하지 않은 프로브</translation>
    </message>
    <message>
        <source>Probe still in contact</source>
        <translation>접촉 중인 프로브</translation>
    </message>
    <message>
        <source>Probe in contact at start</source>
        <translation>시작 시 접촉된 프로브</translation>
    </message>
    <message>
        <source>Probe free at start</source>
        <translation>시작 시 떨어진 프로브</translation>
    </message>
    <message>
        <source>Spline outside XY plane</source>
        <translation>XY 평면 밖의 스플라인</translation>
    </message>
    <message>
        <source>Spline without I and J</source>
        <translation>I, J가 없는 스플라인</translation>
    </message>
    <message>
        <source>Spline too long</source>
        <translation>너무 긴 스플라인</translation>
    </message>
    <message>
        <source>Control point incomplete</source>
        <translation>불완전한 제어점</translation>
    </message>
    <message>
        <source>Invalid control point weight</source>
        <translation>잘못된 제어점 가중치</translation>
    </message>
    <message>
        <source>Weight without control point</source>
        <translation>제어점이 없는 가중치</translation>
    </message>
    <message>
        <source>Too few control points</source>
        <translation>제어점 부족</translation>
    </message>
    <message>
        <source>NURBS block not open</source>
        <translation>열리지 않은 NURBS 블록</translation>
    </message>
    <message>
        <source>NURBS block not closed</source>
        <translation>닫히지 않은 NURBS 블록</translation>
    </message>
    <message>
        <source>Corner without motions</source>
        <translation>이동이 없는 코너</translation>
    </message>
    <message>
        <source>Next corner motion missing</source>
        <translation>코너의 다음 이동 없음</translation>
    </message>
    <message>
        <source>Chamfer and corner radius</source>
        <translation>모따기와 코너 반경</translation>
    </message>
    <message>
        <source>Invalid comma word</source>
        <translation>잘못된 콤마 워드</translation>
    </message>
    <message>
        <source>Corner at compensation change</source>
        <translation>보정 변경 위치의 코너</translation>
    </message>
    <message>
        <source>Negative corner size</source>
        <translation>음수 코너 크기</translation>
    </message>
    <message>
        <source>Corner scaling assumed</source>
        <translation>가정된 코너 스케일링</translation>
    </message>
    <message>
        <source>Corner too large</source>
        <translation>너무 큰 코너</translation>
    </message>
    <message>
        <source>Corner outside plane</source>
        <translation>평면 밖의 코너</translation>
    </message>
    <message>
        <source>Chamfer on arc</source>
        <translation>원호의 모따기</translation>
    </message>
    <message>
        <source>Compensation already active</source>
        <translation>이미 유효한 공구경 보정</translation>
    </message>
    <message>
        <source>Compensation plane unsupported</source>
        <translation>보정 평면 미지원</translation>
    </message>
    <message>
        <source>Compensation under rotation</source>
        <translation>회전 중의 공구경 보정</translation>
    </message>
    <message>
        <source>Not allowed with compensation</source>
        <translation>공구경 보정 중 사용 불가</translation>
    </message>
    <message>
        <source>Compensation suspended</source>
        <translation>일시 취소된 공구경 보정</translation>
    </message>
    <message>
        <source>Compensation diameter 0</source>
        <translation>보정 지름 0</translation>
    </message>
    <message>
        <source>Compensation diameter unknown</source>
        <translation>알 수 없는 보정 지름</translation>
    </message>
    <message>
        <source>Compensation from unknown position</source>
        <translation>알 수 없는 위치의 공구경 보정</translation>
    </message>
    <message>
        <source>Lead-in too short</source>
        <translation>너무 짧은 진입</translation>
    </message>
    <message>
        <source>Arc smaller than tool</source>
        <translation>공구보다 작은 원호</translation>
    </message>
    <message>
        <source>Inside corner too tight</source>
        <translation>너무 좁은 안쪽 코너</translation>
    </message>
    <message>
        <source>Compensation gouge</source>
        <translation>보정에 의한 과절삭</translation>
    </message>
    <message>
        <source>Compensated motion reversed</source>
        <translation>역방향 보정 이동</translation>
    </message>
    <message>
        <source>Stop before inside corner</source>
        <translation>안쪽 코너 앞의 정지</translation>
    </message>
    <message>
        <source>Lead-out on arc</source>
        <translation>원호 이탈</translation>
    </message>
    <message>
        <source>Lead-in on arc</source>
        <translation>원호 진입</translation>
    </message>
    <message>
        <source>Corner not compensated</source>
        <translation>보정되지 않은 코너</translation>
    </message>
    <message>
        <source>Compensation side change</source>
        <translation>보정 방향 변경</translation>
    </message>
    <message>
        <source>Compensation points dropped</source>
        <translation>생략된 보정점</translation>
    </message>
    <message>
        <source>Compensated arc off circle</source>
        <translation>원을 벗어난 보정 원호</translation>
    </message>
    <message>
        <source>Compensation active at end</source>
        <translation>끝까지 유효한 공구경 보정</translation>
    </message>
    <message>
        <source>Code not supported</source>
        <translation>지원되지 않는 코드</translation>
    </message>
    <message>
        <source>Word not supported</source>
        <translation>지원되지 않는 워드</translation>
    </message>
    <message>
        <source>Expressions not supported</source>
        <translation>지원되지 않는 수식</translation>
    </message>
    <message>
        <source>Line dropped</source>
        <translation>건너뛴 줄</translation>
    </message>
    <message>
        <source>Block number too large</source>
        <translation>너무 큰 블록 번호</translation>
    </message>
    <message>
        <source>System command</source>
        <translation>시스템 명령</translation>
    </message>
    <message>
        <source>Real-time command</source>
        <translation>실시간 명령</translation>
    </message>
    <message>
        <source>Real-time reset</source>
        <translation>실시간 리셋</translation>
    </message>
    <message>
        <source>Block delete ignored</source>
        <translation>무시된 블록 스킵</translation>
    </message>
    <message>
        <source>&quot;%&quot; not supported</source>
        <translation>지원되지 않는 &quot;%&quot;</translation>
    </message>
    <message>
        <source>Tool not changed</source>
        <translation>교환되지 않은 공구</translation>
    </message>
    <message>
        <source>Optional stop ignored</source>
        <translation>무시된 선택 정지</translation>
    </message>
    <message>
        <source>Length offset axis</source>
        <translation>길이 보정 축</translation>
    </message>
    <message>
        <source>O word not supported</source>
        <translation>지원되지 않는 O 워드</translation>
    </message>
    <message>
        <source>Length offset number missing</source>
        <translation>길이 보정 번호 없음</translation>
    </message>
    <message>
        <source>Feed rate 0</source>
        <translation>이송 속도 0</translation>
    </message>
    <message>
        <source>Tool length offset missing</source>
        <translation>공구 길이 보정 없음</translation>
    </message>
    <message>
        <source>Work offset not selected</source>
        <translation>선택되지 않은 공작물 좌표계</translation>
    </message>
    <message>
        <source>Length offset mismatch</source>
        <translation>길이 보정 번호 불일치</translation>
    </message>
    <message>
        <source>D word missing</source>
        <translation>D 워드 없음</translation>
    </message>
    <message>
        <source>Compensation start-up on arc</source>
        <translation>원호에서 시작하는 보정</translation>
    </message>
    <message>
        <source>Mixed units</source>
        <translation>혼용된 단위</translation>
    </message>
    <message>
        <source>Modal function left on</source>
        <translation>남아 있는 모달 기능</translation>
    </message>
    <message>
        <source>Tool change too low</source>
        <translation>너무 낮은 공구 교환</translation>
    </message>
    <message>
        <source>Tool change, spindle running</source>
        <translation>주축 회전 중 공구 교환</translation>
    </message>
    <message>
        <source>Unreachable block</source>
        <translation>도달할 수 없는 블록</translation>
    </message>
    <message>
        <source>Tool not in table</source>
        <translation>테이블에 없는 공구</translation>
    </message>
    <message>
        <source>Nearly a half circle</source>
        <translation>거의 반원</translation>
    </message>
    <message>
        <source>File not readable</source>
        <translation>읽을 수 없는 파일</translation>
    </message>
    <message>
        <source>File not writable</source>
        <translation>쓸 수 없는 파일</translation>
    </message>
    <message>
        <source>Not a regular file</source>
        <translation>일반 파일이 아님</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>너무 큰 파일</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>취소됨</translation>
    </message>
    <message>
        <source>More messages</source>
        <translation>추가 메시지</translation>
    </message>
    <message>
        <source>Profile without width</source>
        <translation>폭이 없는 프로파일</translation>
    </message>
    <message>
        <source>Too many profile points</source>
        <translation>프로파일 점이 너무 많음</translation>
    </message>
    <message>
        <source>Profile turns back</source>
        <translation>되돌아가는 프로파일</translation>
    </message>
    <message>
        <source>Invalid profile point</source>
        <translation>잘못된 프로파일 점</translation>
    </message>
    <message>
        <source>Profile falls</source>
        <translation>내려가는 프로파일</translation>
    </message>
    <message>
        <source>Profile not at the tip</source>
        <translation>선단에서 시작하지 않는 프로파일</translation>
    </message>
    <message>
        <source>Profile arc radius too small</source>
        <translation>너무 작은 프로파일 원호 반경</translation>
    </message>
    <message>
        <source>Profile arc centre mismatch</source>
        <translation>프로파일 원호 중심 불일치</translation>
    </message>
    <message>
        <source>Profile arc turns back</source>
        <translation>되돌아가는 프로파일 원호</translation>
    </message>
    <message>
        <source>Profile tip without width</source>
        <translation>폭이 없는 프로파일 선단</translation>
    </message>
    <message>
        <source>Profile arcs too large</source>
        <translation>너무 큰 프로파일 원호</translation>
    </message>
    <message>
        <source>Tip too large</source>
        <translation>너무 큰 선단</translation>
    </message>
    <message>
        <source>Pilot too large</source>
        <translation>너무 큰 파일럿</translation>
    </message>
    <message>
        <source>Pilot too short</source>
        <translation>너무 짧은 파일럿</translation>
    </message>
    <message>
        <source>Lead too long</source>
        <translation>너무 긴 절입부</translation>
    </message>
    <message>
        <source>Corner radius too large</source>
        <translation>너무 큰 코너 반경</translation>
    </message>
    <message>
        <source>Taper too low</source>
        <translation>너무 낮은 테이퍼</translation>
    </message>
    <message>
        <source>Neck too thick</source>
        <translation>너무 굵은 목</translation>
    </message>
    <message>
        <source>Head too high</source>
        <translation>너무 높은 머리</translation>
    </message>
    <message>
        <source>Cutter value not numeric</source>
        <translation>숫자가 아닌 커터 값</translation>
    </message>
    <message>
        <source>Cutter value out of range</source>
        <translation>범위를 벗어난 커터 값</translation>
    </message>
    <message>
        <source>Duplicate cutter key</source>
        <translation>중복된 커터 키</translation>
    </message>
    <message>
        <source>Unknown cutter key</source>
        <translation>알 수 없는 커터 키</translation>
    </message>
    <message>
        <source>Cutter key missing</source>
        <translation>커터 키 없음</translation>
    </message>
    <message>
        <source>Unknown cutter shape</source>
        <translation>알 수 없는 커터 형상</translation>
    </message>
    <message>
        <source>Flute length too short</source>
        <translation>너무 짧은 날 길이</translation>
    </message>
    <message>
        <source>Invalid tool number</source>
        <translation>잘못된 공구 번호</translation>
    </message>
    <message>
        <source>Tool file empty</source>
        <translation>빈 공구 파일</translation>
    </message>
    <message>
        <source>Invalid tool entry</source>
        <translation>잘못된 공구 항목</translation>
    </message>
    <message>
        <source>Duplicate tool</source>
        <translation>중복된 공구</translation>
    </message>
    <message>
        <source>Tool without a cutter</source>
        <translation>커터가 없는 공구</translation>
    </message>
    <message>
        <source>Invalid tool source</source>
        <translation>잘못된 공구 출처</translation>
    </message>
    <message>
        <source>Tool file not readable</source>
        <translation>읽을 수 없는 공구 파일</translation>
    </message>
    <message>
        <source>Unknown tool key</source>
        <translation>알 수 없는 공구 키</translation>
    </message>
    <message>
        <source>Outline out of range</source>
        <translation>범위를 벗어난 윤곽</translation>
    </message>
    <message>
        <source>Outline without area</source>
        <translation>면적이 없는 윤곽</translation>
    </message>
    <message>
        <source>Outline crosses itself</source>
        <translation>자기 교차 윤곽</translation>
    </message>
    <message>
        <source>Invalid grid spacing</source>
        <translation>잘못된 격자 간격</translation>
    </message>
    <message>
        <source>Invalid stock size</source>
        <translation>잘못된 소재 크기</translation>
    </message>
    <message>
        <source>Stock too narrow</source>
        <translation>너무 좁은 소재</translation>
    </message>
    <message>
        <source>Invalid stock origin</source>
        <translation>잘못된 소재 원점</translation>
    </message>
    <message>
        <source>Grid too coarse</source>
        <translation>너무 거친 격자</translation>
    </message>
    <message>
        <source>Grid too fine</source>
        <translation>너무 촘촘한 격자</translation>
    </message>
    <message>
        <source>Grid lost in rounding</source>
        <translation>반올림으로 사라지는 격자</translation>
    </message>
    <message>
        <source>Not enough memory</source>
        <translation>메모리 부족</translation>
    </message>
    <message>
        <source>Grid needs too much memory</source>
        <translation>격자 메모리 초과</translation>
    </message>
    <message>
        <source>Box without area</source>
        <translation>면적이 없는 영역</translation>
    </message>
    <message>
        <source>Box outside the stock</source>
        <translation>소재 밖의 영역</translation>
    </message>
    <message>
        <source>Stock mesh too far</source>
        <translation>너무 먼 소재 메시</translation>
    </message>
    <message>
        <source>Stock mesh flat</source>
        <translation>부피가 없는 소재 메시</translation>
    </message>
    <message>
        <source>Too many mesh layers</source>
        <translation>메시 층이 너무 많음</translation>
    </message>
    <message>
        <source>Saved stock empty</source>
        <translation>비어 있는 저장 소재</translation>
    </message>
    <message>
        <source>Invalid stock size text</source>
        <translation>잘못된 소재 크기 표기</translation>
    </message>
    <message>
        <source>Stock size not positive</source>
        <translation>양수가 아닌 소재 크기</translation>
    </message>
    <message>
        <source>Invalid point</source>
        <translation>잘못된 점</translation>
    </message>
    <message>
        <source>Stock incomplete</source>
        <translation>불완전한 소재</translation>
    </message>
    <message>
        <source>Stock mesh not closed</source>
        <translation>닫히지 않은 소재 메시</translation>
    </message>
    <message>
        <source>Undercut in stock</source>
        <translation>소재의 언더컷</translation>
    </message>
    <message>
        <source>Stock resampled</source>
        <translation>재샘플링된 소재</translation>
    </message>
    <message>
        <source>Surface too large</source>
        <translation>표면이 너무 큼</translation>
    </message>
    <message>
        <source>The surface needs more than the {} of memory that are available, and is drawn without decimation; any surface on a grid of {} mm would fit.</source>
        <translation>표면에 사용 가능한 메모리 {}보다 많은 메모리가 필요하여 단순화하지 않고 표시합니다. 격자 {} mm에서는 어떤 표면도 들어갑니다.</translation>
    </message>
    <message>
        <source>Choose a coarser grid or a larger allowance.</source>
        <translation>더 거친 격자나 더 큰 허용 오차를 선택하십시오.</translation>
    </message>
    <message>
        <source>The surface needs more than the {} of memory that are available; any surface on a grid of {} mm would fit.</source>
        <translation>표면에 사용 가능한 메모리 {}보다 많은 메모리가 필요합니다. 격자 {} mm에서는 어떤 표면도 들어갑니다.</translation>
    </message>
    <message>
        <source>Increase the grid spacing or the allowance, or close other programs.</source>
        <translation>격자 간격이나 허용 오차를 늘리거나 다른 프로그램을 종료하십시오.</translation>
    </message>
    <message>
        <source>Map too large for method</source>
        <translation>이 방법에 너무 큰 Z맵</translation>
    </message>
    <message>
        <source>STL file cut off</source>
        <translation>잘린 STL 파일</translation>
    </message>
    <message>
        <source>STL syntax error</source>
        <translation>STL 구문 오류</translation>
    </message>
    <message>
        <source>Not an STL file</source>
        <translation>STL 파일이 아님</translation>
    </message>
    <message>
        <source>No usable facets</source>
        <translation>사용할 수 있는 면 없음</translation>
    </message>
    <message>
        <source>Data after STL end</source>
        <translation>STL 끝 뒤의 데이터</translation>
    </message>
    <message>
        <source>STL end missing</source>
        <translation>STL 끝 없음</translation>
    </message>
    <message>
        <source>Facets not finite</source>
        <translation>유한하지 않은 면</translation>
    </message>
    <message>
        <source>Degenerate facets</source>
        <translation>축퇴된 면</translation>
    </message>
    <message>
        <source>Normals against winding</source>
        <translation>정점 순서와 반대인 법선</translation>
    </message>
    <message>
        <source>Duplicate facets</source>
        <translation>중복된 면</translation>
    </message>
    <message>
        <source>Mesh not closed</source>
        <translation>닫히지 않은 메시</translation>
    </message>
    <message>
        <source>Mesh not manifold</source>
        <translation>비다양체 메시</translation>
    </message>
    <message>
        <source>Flipped facets</source>
        <translation>뒤집힌 면</translation>
    </message>
    <message>
        <source>Mesh inside out</source>
        <translation>안팎이 뒤집힌 메시</translation>
    </message>
    <message>
        <source>Mesh far from origin</source>
        <translation>원점에서 먼 메시</translation>
    </message>
    <message>
        <source>Mesh without size</source>
        <translation>크기가 없는 메시</translation>
    </message>
    <message>
        <source>Mesh size suspect</source>
        <translation>의심스러운 메시 크기</translation>
    </message>
    <message>
        <source>Not a ZIP archive</source>
        <translation>ZIP 압축 파일이 아님</translation>
    </message>
    <message>
        <source>Unknown export format</source>
        <translation>알 수 없는 내보내기 형식</translation>
    </message>
    <message>
        <source>Export rounded too coarsely</source>
        <translation>너무 거칠게 반올림된 내보내기</translation>
    </message>
    <message>
        <source>Nothing to export</source>
        <translation>내보낼 것 없음</translation>
    </message>
    <message>
        <source>Coordinate not finite</source>
        <translation>유한하지 않은 좌표</translation>
    </message>
    <message>
        <source>STL too coarse</source>
        <translation>너무 거친 STL</translation>
    </message>
    <message>
        <source>Too many triangles</source>
        <translation>삼각형이 너무 많음</translation>
    </message>
    <message>
        <source>Coordinate out of range</source>
        <translation>범위를 벗어난 좌표</translation>
    </message>
    <message>
        <source>Unsupported NPY type</source>
        <translation>지원하지 않는 NPY 형식</translation>
    </message>
    <message>
        <source>Unsupported NPY order</source>
        <translation>지원하지 않는 NPY 순서</translation>
    </message>
    <message>
        <source>Unsupported NPY shape</source>
        <translation>지원하지 않는 NPY 형상</translation>
    </message>
    <message>
        <source>NPY file cut off</source>
        <translation>잘린 NPY 파일</translation>
    </message>
    <message>
        <source>Height not finite</source>
        <translation>유한하지 않은 높이</translation>
    </message>
    <message>
        <source>NPY header not readable</source>
        <translation>읽을 수 없는 NPY 헤더</translation>
    </message>
    <message>
        <source>Not an NPY file</source>
        <translation>NPY 파일이 아님</translation>
    </message>
    <message>
        <source>Unsupported NPY version</source>
        <translation>지원하지 않는 NPY 버전</translation>
    </message>
    <message>
        <source>JSON nested too deeply</source>
        <translation>JSON 중첩이 너무 깊음</translation>
    </message>
    <message>
        <source>Not valid JSON</source>
        <translation>올바른 JSON이 아님</translation>
    </message>
    <message>
        <source>Not a Proveout job</source>
        <translation>Proveout 작업이 아님</translation>
    </message>
    <message>
        <source>Job of newer version</source>
        <translation>새 버전의 작업</translation>
    </message>
    <message>
        <source>Program name not UTF-8</source>
        <translation>UTF-8이 아닌 프로그램 이름</translation>
    </message>
    <message>
        <source>File outside job folder</source>
        <translation>작업 폴더 밖의 파일</translation>
    </message>
    <message>
        <source>Unknown job field</source>
        <translation>알 수 없는 작업 필드</translation>
    </message>
    <message>
        <source>Invalid job field</source>
        <translation>잘못된 작업 필드</translation>
    </message>
    <message>
        <source>Invalid outline point</source>
        <translation>잘못된 윤곽 점</translation>
    </message>
    <message>
        <source>Outline loop too short</source>
        <translation>너무 짧은 윤곽 루프</translation>
    </message>
    <message>
        <source>Outline empty</source>
        <translation>빈 윤곽</translation>
    </message>
    <message>
        <source>Unknown stock key</source>
        <translation>알 수 없는 소재 키</translation>
    </message>
    <message>
        <source>Invalid stock value</source>
        <translation>잘못된 소재 값</translation>
    </message>
    <message>
        <source>Invalid stock option</source>
        <translation>잘못된 소재 선택</translation>
    </message>
    <message>
        <source>Stock file missing</source>
        <translation>소재 파일 없음</translation>
    </message>
    <message>
        <source>Duplicate stock key</source>
        <translation>중복된 소재 키</translation>
    </message>
    <message>
        <source>Stock key missing</source>
        <translation>소재 키 없음</translation>
    </message>
    <message>
        <source>Unknown stock shape</source>
        <translation>알 수 없는 소재 형상</translation>
    </message>
    <message>
        <source>Saved stock damaged</source>
        <translation>손상된 저장 소재</translation>
    </message>
    <message>
        <source>Not a saved stock</source>
        <translation>저장된 소재가 아님</translation>
    </message>
    <message>
        <source>Stock of newer version</source>
        <translation>새 버전의 소재</translation>
    </message>
    <message>
        <source>Saved grid mismatch</source>
        <translation>저장된 격자 불일치</translation>
    </message>
    <message>
        <source>Saved heights invalid</source>
        <translation>잘못된 저장 높이 값</translation>
    </message>
    <message>
        <source>Saved height invalid</source>
        <translation>잘못된 저장 높이</translation>
    </message>
    <message>
        <source>Invalid machine value</source>
        <translation>잘못된 기계 값</translation>
    </message>
    <message>
        <source>Unknown machine key</source>
        <translation>알 수 없는 기계 키</translation>
    </message>
    <message>
        <source>Parameter out of range</source>
        <translation>범위를 벗어난 파라미터</translation>
    </message>
    <message>
        <source>Program never cuts</source>
        <translation>절삭하지 않는 프로그램</translation>
    </message>
    <message>
        <source>Stock missed</source>
        <translation>소재를 벗어남</translation>
    </message>
    <message>
        <source>Grid coarse</source>
        <translation>거친 격자</translation>
    </message>
    <message>
        <source>Rapid cuts stock</source>
        <translation>급속 이송 중 소재 절삭</translation>
    </message>
    <message>
        <source>Cut beyond flutes</source>
        <translation>날 길이를 넘는 절삭</translation>
    </message>
    <message>
        <source>Neck in stock</source>
        <translation>소재에 닿는 목</translation>
    </message>
    <message>
        <source>Rapid not checked</source>
        <translation>검사되지 않은 급속 이송</translation>
    </message>
    <message>
        <source>Stock above head not shown</source>
        <translation>표시되지 않은 머리 위 소재</translation>
    </message>
    <message>
        <source>More findings</source>
        <translation>추가 결과</translation>
    </message>
    <message>
        <source>Tool not confirmed</source>
        <translation>확인되지 않은 공구</translation>
    </message>
    <message>
        <source>Tool assumed</source>
        <translation>가정된 공구</translation>
    </message>
    <message>
        <source>Tool not defined</source>
        <translation>정의되지 않은 공구</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>공구 없음</translation>
    </message>
    <message>
        <source>Box needs too much memory</source>
        <translation>영역 메모리 초과</translation>
    </message>
    <message>
        <source>Out of memory</source>
        <translation>메모리 부족</translation>
    </message>
    <message>
        <source>Condition too long</source>
        <translation>너무 긴 조건</translation>
    </message>
    <message>
        <source>Invalid condition</source>
        <translation>잘못된 조건</translation>
    </message>
    <message>
        <source>Study stopped</source>
        <translation>연구 중단</translation>
    </message>
    <message>
        <source>Nothing to optimise</source>
        <translation>최적화할 것 없음</translation>
    </message>
    <message>
        <source>Internal error</source>
        <translation>내부 오류</translation>
    </message>
    <message>
        <source>Backup damaged</source>
        <translation>손상된 백업</translation>
    </message>
    <message>
        <source>File not opened</source>
        <translation>파일을 열지 않음</translation>
    </message>
    <message>
        <source>File changed on disk</source>
        <translation>디스크에서 변경된 파일</translation>
    </message>
    <message>
        <source>Stock file changed</source>
        <translation>변경된 소재 파일</translation>
    </message>
    <message>
        <source>Stock too large</source>
        <translation>너무 큰 소재</translation>
    </message>
    <message>
        <source>No stock</source>
        <translation>소재 없음</translation>
    </message>
    <message>
        <source>Export in progress</source>
        <translation>내보내는 중</translation>
    </message>
    <message>
        <source>Export too large</source>
        <translation>너무 큰 내보내기</translation>
    </message>
    <message>
        <source>Export failed</source>
        <translation>내보내기 실패</translation>
    </message>
    <message>
        <source>Detail region too large</source>
        <translation>너무 큰 상세 영역</translation>
    </message>
    <message>
        <source>OpenGL not available</source>
        <translation>OpenGL을 사용할 수 없음</translation>
    </message>
    <message>
        <source>Export to a format with coordinates in double precision: {4}.</source>
        <translation>좌표를 배정밀도로 담는 형식으로 내보내십시오: {4}.</translation>
    </message>
    <message>
        <source>Export to a format with coordinates in double precision: {3}.</source>
        <translation>좌표를 배정밀도로 담는 형식으로 내보내십시오: {3}.</translation>
    </message>
    <message>
        <source>Rounded to single precision, the mesh deviates from the z-map by up to {} mm, more than the error allowance of {} mm; a format in double precision would keep {} mm.</source>
        <translation>단정밀도로 반올림하면 파일이 Z맵에서 최대 {} mm 벗어나 허용 오차 {} mm를 넘습니다. 배정밀도 형식이라면 {} mm를 유지합니다.</translation>
    </message>
    <message>
        <source>Touching parts set apart</source>
        <translation>맞닿은 부분을 떼어 놓음</translation>
    </message>
    <message>
        <source>The mesh deviates from the z-map by up to {} mm, more than the error allowance of {} mm, where parts of the solid that touch at a steep wall are set apart.</source>
        <translation>가파른 벽에서 맞닿는 솔리드 부분을 떼어 놓은 곳에서 메시가 Z맵에서 최대 {} mm 벗어나 허용 오차 {} mm를 넘습니다.</translation>
    </message>
    <message>
        <source>Make the stock slightly lower or higher, so that cuts do not end at its floor.</source>
        <translation>절삭이 소재 바닥에서 끝나지 않도록 소재 높이를 조금 바꾸십시오.</translation>
    </message>
    <message>
        <source>Rounding too large</source>
        <translation>반올림이 너무 큼</translation>
    </message>
    <message>
        <source>Single precision rounds positions in this stock by up to {} mm, more than half of the error allowance of {} mm; an allowance of at least {} mm or a format in double precision is needed.</source>
        <translation>단정밀도는 이 소재의 위치를 최대 {} mm 반올림하며, 이는 허용 오차 {} mm의 절반을 넘습니다. {} mm 이상의 허용 오차 또는 배정밀도 형식이 필요합니다.</translation>
    </message>
    <message>
        <source>Rounding to single precision changes heights on steep walls by up to {} mm, more than half of the error allowance of {} mm; an allowance of about {} mm or a format in double precision is needed.</source>
        <translation>단정밀도로 반올림하면 가파른 벽에서 높이가 최대 {} mm 바뀌며, 이는 허용 오차 {} mm의 절반을 넘습니다. 약 {} mm의 허용 오차 또는 배정밀도 형식이 필요합니다.</translation>
    </message>
    <message>
        <source>Export to a format with coordinates in double precision ({4}), or move the stock nearer to the origin.</source>
        <translation>좌표를 배정밀도로 담는 형식({4})으로 내보내거나 소재를 원점에 더 가깝게 두십시오.</translation>
    </message>
    <message>
        <source>The coordinates of an STL file are too coarse for this mesh so far from the origin: {} triangles would collapse or turn over, {} vertices meet others; a format in double precision can hold it.</source>
        <translation>원점에서 이렇게 먼 메시에는 STL 파일의 좌표가 너무 거칩니다. 삼각형 {}개가 뭉개지거나 뒤집히고 정점 {}개가 다른 정점과 겹칩니다. 배정밀도 형식으로는 담을 수 있습니다.</translation>
    </message>
    <message>
        <source>Post-process it for one of these dialects: {4}; if it is in one of them after all, choose it.</source>
        <translation>다음 제어기 방식 중 하나로 포스트 처리하십시오: {4}. 실제로 이 중 하나라면 그 방식을 고르십시오.</translation>
    </message>
    <message>
        <source>Tool change time</source>
        <translation>공구 교환 시간</translation>
    </message>
    <message>
        <source>One tenth of the smallest cutter diameter, with 1 to 4 million points</source>
        <translation>가장 작은 공구 지름의 10분의 1, 점 100만~400만 개</translation>
    </message>
    <message>
        <source>Dialect of the program</source>
        <translation>프로그램의 제어기 방식</translation>
    </message>
    <message>
        <source>The control that the program is written for; arcs, cycles, offsets and numbers differ from control to control.</source>
        <translation>프로그램을 작성한 대상 제어기입니다. 원호, 사이클, 옵셋, 숫자를 읽는 방식은 제어기마다 다릅니다.</translation>
    </message>
    <message>
        <source>Detected from the program</source>
        <translation>프로그램에서 감지</translation>
    </message>
    <message>
        <source>Block delete (/)</source>
        <translation>블록 스킵(/)</translation>
    </message>
    <message>
        <source>Skip blocks that start with /, like the switch on the control.</source>
        <translation>제어기의 블록 스킵 스위치처럼 /로 시작하는 블록을 건너뜁니다.</translation>
    </message>
    <message>
        <source>Type A: straight to the path</source>
        <translation>A형: 경로로 곧바로</translation>
    </message>
    <message>
        <source>Type B: round outside corners</source>
        <translation>B형: 바깥쪽 코너를 돌아서</translation>
    </message>
    <message>
        <source>Cutter comp start-up</source>
        <translation>공구경 보정 스타트업</translation>
    </message>
    <message>
        <source>Start-up and cancel of Fanuc and Haas cutter compensation at outside corners, as set on the control (Fanuc parameter 5003 SUP, Haas setting 43): type A straight, type B round them.</source>
        <translation>바깥쪽 코너에서 Fanuc과 Haas 공구경 보정의 스타트업과 취소 방식으로, 제어기 설정과 같습니다(Fanuc 파라미터 5003 SUP, Haas 설정 43). A형은 곧바로, B형은 코너를 돌아서 이동합니다.</translation>
    </message>
    <message>
        <source>Ignored M codes</source>
        <translation>무시할 M 코드</translation>
    </message>
    <message>
        <source>M codes that move no axis on this machine: clamps, doors, air, chip conveyor. They are ignored and listed as notes. Results after any other unknown code are unverified.</source>
        <translation>이 기계에서 축을 움직이지 않는 M 코드입니다: 클램프, 도어, 에어, 칩 컨베이어. 무시하고 참고로 표시합니다. 그 밖의 알 수 없는 코드 이후의 결과는 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>Stock shape</source>
        <translation>소재 형상</translation>
    </message>
    <message>
        <source>Invalid holder segment</source>
        <translation>잘못된 홀더 구간</translation>
    </message>
    <message>
        <source>“{}” is not a segment of a holder; a cylinder is written as {}, a cone as {}.</source>
        <translation>“{}”은(는) 홀더 구간이 아닙니다. 원통은 {}, 원뿔은 {}와 같이 적습니다.</translation>
    </message>
    <message>
        <source>Holder size out of range</source>
        <translation>범위를 벗어난 홀더 치수</translation>
    </message>
    <message>
        <source>The segment {} of the holder has a diameter or height that is out of range, {} to {} mm.</source>
        <translation>홀더 구간 {}의 지름이나 높이가 {}~{} mm 범위를 벗어났습니다.</translation>
    </message>
    <message>
        <source>Too many holder segments</source>
        <translation>너무 많은 홀더 구간</translation>
    </message>
    <message>
        <source>The holder has more than {} segments.</source>
        <translation>홀더 구간이 {}개를 넘습니다.</translation>
    </message>
    <message>
        <source>Holder without stick-out</source>
        <translation>돌출 길이 없는 홀더</translation>
    </message>
    <message>
        <source>A holder needs the key so, the stick-out from the tip to the face of the holder.</source>
        <translation>홀더에는 선단에서 홀더 단면까지의 돌출 길이인 so 키가 필요합니다.</translation>
    </message>
    <message>
        <source>Stick-out too short</source>
        <translation>너무 짧은 돌출 길이</translation>
    </message>
    <message>
        <source>The stick-out so={} is less than the height of the cutter&apos;s profile, {} mm.</source>
        <translation>돌출 길이 so={}이(가) 커터 프로파일의 높이 {} mm보다 짧습니다.</translation>
    </message>
    <message>
        <source>Stick-out, from tip to holder (0: unknown)</source>
        <translation>돌출 길이, 선단에서 홀더까지(0: 알 수 없음)</translation>
    </message>
    <message>
        <source>Holder, DIAMETERxHEIGHT+… from its face upwards</source>
        <translation>홀더, 단면에서 위쪽으로 적은 지름x높이+… 형식</translation>
    </message>
    <message>
        <source>The value of {}, “{}”, is not a whole number.</source>
        <translation>{}의 값 “{}”은(는) 정수가 아닙니다.</translation>
    </message>
    <message>
        <source>Chip thickness without teeth</source>
        <translation>날 수가 없는 칩 두께</translation>
    </message>
    <message>
        <source>A maximum chip thickness, maxchip, needs the key z, the number of teeth of the tool.</source>
        <translation>최대 칩 두께 maxchip에는 공구의 날 수인 z 키가 필요합니다.</translation>
    </message>
    <message>
        <source>Pitch of the thread (0: unknown)</source>
        <translation>나사 피치(0: 알 수 없음)</translation>
    </message>
    <message>
        <source>Teeth (0: unknown)</source>
        <translation>날 수(0: 알 수 없음)</translation>
    </message>
    <message>
        <source>Centre-cutting (1: yes, 0: no)</source>
        <translation>센터 커팅(1: 예, 0: 아니요)</translation>
    </message>
    <message>
        <source>Steepest ramp into material</source>
        <translation>소재로 들어가는 최대 램프 각도</translation>
    </message>
    <message>
        <source>Maximum axial depth (0: any)</source>
        <translation>최대 축방향 절삭 깊이(0: 제한 없음)</translation>
    </message>
    <message>
        <source>Maximum engagement (0: any)</source>
        <translation>최대 반경방향 물림(0: 제한 없음)</translation>
    </message>
    <message>
        <source>Maximum chip thickness (0: any)</source>
        <translation>최대 칩 두께(0: 제한 없음)</translation>
    </message>
    <message>
        <source>Maximum spindle speed (0: any)</source>
        <translation>최대 주축 회전수(0: 제한 없음)</translation>
    </message>
    <message>
        <source>Maximum feed in a cut (0: any)</source>
        <translation>절삭 중 최대 이송 속도(0: 제한 없음)</translation>
    </message>
    <message>
        <source>Maximum surface speed (0: any)</source>
        <translation>최대 절삭 속도(0: 제한 없음)</translation>
    </message>
    <message>
        <source>Maximum removal rate (0: any)</source>
        <translation>최대 절삭률(0: 제한 없음)</translation>
    </message>
    <message>
        <source>Maximum spindle speed</source>
        <translation>최대 주축 회전수</translation>
    </message>
    <message>
        <source>Programs are checked for higher spindle speeds; 0: unknown, not checked.</source>
        <translation>프로그램에 더 높은 주축 회전수가 있는지 검사합니다. 0: 알 수 없음, 검사하지 않음.</translation>
    </message>
    <message>
        <source>Motion not allowed for tool</source>
        <translation>공구에 허용되지 않는 이동</translation>
    </message>
    <message>
        <source>The tool plunges {} mm deep into material, but is not centre-cutting.</source>
        <translation>공구가 소재로 {} mm 깊이까지 수직 절입하지만 센터 커팅 공구가 아닙니다.</translation>
    </message>
    <message>
        <source>Drill a hole first, go down on a ramp, or set centre=1 for the tool if it may.</source>
        <translation>먼저 구멍을 뚫거나, 램프로 내려가거나, 허용되는 공구라면 centre=1로 설정하십시오.</translation>
    </message>
    <message>
        <source>The plunge goes {} mm deep into material with the unconfirmed tool T{}, which is not centre-cutting.</source>
        <translation>소재로 {} mm 깊이까지 수직 절입하지만, 확인되지 않은 공구 T{}은(는) 센터 커팅 공구가 아닙니다.</translation>
    </message>
    <message>
        <source>Holder collision</source>
        <translation>홀더 충돌</translation>
    </message>
    <message>
        <source>The holder collides with the stock, {} mm deep at X{} Y{} Z{}.</source>
        <translation>홀더가 소재와 충돌합니다(깊이 {} mm, 위치 X{} Y{} Z{}).</translation>
    </message>
    <message>
        <source>Remove the stock there first, or choose a tool with more stick-out.</source>
        <translation>그곳의 소재를 먼저 제거하거나 돌출 길이가 더 긴 공구를 선택하십시오.</translation>
    </message>
    <message>
        <source>The holder collides with the stock, {} mm deep at X{} Y{} Z{}, with the unconfirmed tool T{}.</source>
        <translation>홀더가 소재와 충돌합니다(깊이 {} mm, 위치 X{} Y{} Z{}, 확인되지 않은 공구 T{}).</translation>
    </message>
    <message>
        <source>Shank collision</source>
        <translation>생크 충돌</translation>
    </message>
    <message>
        <source>The shank collides with the stock, {} mm deep at X{} Y{} Z{}.</source>
        <translation>생크가 소재와 충돌합니다(깊이 {} mm, 위치 X{} Y{} Z{}).</translation>
    </message>
    <message>
        <source>Remove the stock there first, or choose a tool with a thinner shank.</source>
        <translation>그곳의 소재를 먼저 제거하거나 생크가 더 가는 공구를 선택하십시오.</translation>
    </message>
    <message>
        <source>The shank collides with the stock, {} mm deep at X{} Y{} Z{}, with the unconfirmed tool T{}.</source>
        <translation>생크가 소재와 충돌합니다(깊이 {} mm, 위치 X{} Y{} Z{}, 확인되지 않은 공구 T{}).</translation>
    </message>
    <message>
        <source>Not checked: not enough memory</source>
        <translation>검사 안 됨: 메모리 부족</translation>
    </message>
    <message>
        <source>The program is not checked: that needs {}, but only {} are available.</source>
        <translation>프로그램을 검사하지 않았습니다: {}이(가) 필요하지만 {}만 사용할 수 있습니다.</translation>
    </message>
    <message>
        <source>Choose a coarser grid, or close other programs.</source>
        <translation>더 거친 격자를 선택하거나 다른 프로그램을 닫으십시오.</translation>
    </message>
    <message>
        <source>There is not enough memory to check the program.</source>
        <translation>프로그램을 검사하기에 메모리가 부족합니다.</translation>
    </message>
    <message>
        <source>The check failed: {}.</source>
        <translation>검사에 실패했습니다: {}.</translation>
    </message>
    <message>
        <source>Everything that needs a stock</source>
        <translation>소재가 필요한 모든 항목</translation>
    </message>
    <message>
        <source>Collisions of the tool holder</source>
        <translation>홀더 충돌</translation>
    </message>
    <message>
        <source>Collisions of the shank</source>
        <translation>생크 충돌</translation>
    </message>
    <message>
        <source>Collisions with fixtures</source>
        <translation>고정구와의 충돌</translation>
    </message>
    <message>
        <source>Travel limits of the machine</source>
        <translation>기계의 이동 한계</translation>
    </message>
    <message>
        <source>Load of the tools</source>
        <translation>공구 부하</translation>
    </message>
    <message>
        <source>Undercuts</source>
        <translation>언더컷</translation>
    </message>
    <message>
        <source>Moves that depend on probing</source>
        <translation>프로빙에 따라 달라지는 이동</translation>
    </message>
    <message>
        <source>What the operator does at a program stop</source>
        <translation>프로그램 정지에서 작업자가 하는 일</translation>
    </message>
    <message>
        <source>Spindle stopped</source>
        <translation>주축 정지</translation>
    </message>
    <message>
        <source>The cutter cuts {} mm deep while the spindle is stopped.</source>
        <translation>주축이 정지된 상태에서 공구가 {} mm 깊이로 절삭합니다.</translation>
    </message>
    <message>
        <source>Program M3 with a speed S before the cut.</source>
        <translation>절삭 전에 회전수 S와 함께 M3을 지령하십시오.</translation>
    </message>
    <message>
        <source>Spindle reversed</source>
        <translation>주축 역회전</translation>
    </message>
    <message>
        <source>The cutter cuts {} mm deep while the spindle turns counterclockwise (M4).</source>
        <translation>주축이 반시계 방향(M4)으로 회전하는 상태에서 공구가 {} mm 깊이로 절삭합니다.</translation>
    </message>
    <message>
        <source>Program M3, or use a left-hand tool and turn this rule off.</source>
        <translation>M3을 지령하거나, 왼쪽 날 공구를 사용하고 이 규칙을 끄십시오.</translation>
    </message>
    <message>
        <source>Feed rate too high</source>
        <translation>이송 속도 초과</translation>
    </message>
    <message>
        <source>The feed rate of {} mm/min is above the maximum of the machine, {} mm/min.</source>
        <translation>이송 속도 {} mm/min이(가) 기계의 최댓값 {} mm/min을(를) 넘습니다.</translation>
    </message>
    <message>
        <source>Reduce F, or correct the machine values.</source>
        <translation>F를 줄이거나 기계 값을 수정하십시오.</translation>
    </message>
    <message>
        <source>The tool moves sideways in material, {} mm deep, but only cuts along its axis.</source>
        <translation>공구가 소재 속 {} mm 깊이에서 옆으로 이동하지만, 이 공구는 축 방향으로만 절삭합니다.</translation>
    </message>
    <message>
        <source>Retract above the hole before moving in X or Y, or choose a milling cutter.</source>
        <translation>X 또는 Y로 이동하기 전에 구멍 위로 후퇴하거나 밀링 공구를 선택하십시오.</translation>
    </message>
    <message>
        <source>Nothing cut</source>
        <translation>절삭 없음</translation>
    </message>
    <message>
        <source>The program does not touch the stock.</source>
        <translation>프로그램이 소재에 닿지 않습니다.</translation>
    </message>
    <message>
        <source>Check the position and the size of the stock, the work offset and the tools.</source>
        <translation>소재의 위치와 크기, 공작물 좌표계, 공구를 확인하십시오.</translation>
    </message>
    <message>
        <source>The program removes only {} % of the stock, less than {} %.</source>
        <translation>프로그램이 소재의 {} %만 제거합니다({} % 미만).</translation>
    </message>
    <message>
        <source>Wrong unit suspected</source>
        <translation>단위 오류 의심</translation>
    </message>
    <message>
        <source>The cuts extend over {} times the size of the stock, about as many as an inch has millimetres.</source>
        <translation>절삭 범위가 소재 크기의 {}배로, 1인치당 밀리미터 수와 비슷합니다.</translation>
    </message>
    <message>
        <source>Check G20 and G21, and the unit of the stock.</source>
        <translation>G20과 G21, 소재의 단위를 확인하십시오.</translation>
    </message>
    <message>
        <source>The stock is {} times the size of the cuts, about as many as an inch has millimetres.</source>
        <translation>소재가 절삭 범위의 {}배로, 1인치당 밀리미터 수와 비슷합니다.</translation>
    </message>
    <message>
        <source>Cutter below stock</source>
        <translation>소재 아래로 내려간 공구</translation>
    </message>
    <message>
        <source>The cutter goes {} mm below the bottom of the stock; {} mm are allowed.</source>
        <translation>공구가 소재 바닥보다 {} mm 아래로 내려갑니다. 허용값은 {} mm입니다.</translation>
    </message>
    <message>
        <source>Raise the cut, place the stock higher, or allow more if there is room below.</source>
        <translation>절삭을 높이거나 소재를 더 높이 놓으십시오. 아래에 공간이 있으면 더 허용하십시오.</translation>
    </message>
    <message>
        <source>Piece comes loose</source>
        <translation>조각 분리</translation>
    </message>
    <message>
        <source>A piece of {} mm³ has come loose from the rest of the stock.</source>
        <translation>{} mm³ 크기의 조각이 나머지 소재에서 분리되었습니다.</translation>
    </message>
    <message>
        <source>Leave tabs, or turn this rule off if the piece is held.</source>
        <translation>탭을 남기거나, 조각이 고정되어 있으면 이 규칙을 끄십시오.</translation>
    </message>
    <message>
        <source>Feeding in air</source>
        <translation>공중 절삭 이송</translation>
    </message>
    <message>
        <source>The cutter moves through air at feed for {} s; up to {} s are not reported.</source>
        <translation>공구가 {}초 동안 절삭 이송으로 공중을 이동합니다. {}초까지는 보고하지 않습니다.</translation>
    </message>
    <message>
        <source>Approach with G0 where it is safe.</source>
        <translation>안전한 곳에서는 G0으로 접근하십시오.</translation>
    </message>
    <message>
        <source>Size and position of the stock, which is fitted to the toolpath</source>
        <translation>공구 경로에 맞춘 소재의 크기와 위치</translation>
    </message>
    <message>
        <source>The field &quot;{}&quot; must not be empty.</source>
        <translation>필드 &quot;{}&quot;은(는) 비어 있으면 안 됩니다.</translation>
    </message>
    <message>
        <source>Least removal</source>
        <translation>최소 제거량</translation>
    </message>
    <message>
        <source>A program that removes less of the stock counts as not cutting.</source>
        <translation>소재를 이보다 적게 제거하는 프로그램은 절삭하지 않는 것으로 봅니다.</translation>
    </message>
    <message>
        <source>Room below stock</source>
        <translation>소재 아래 여유</translation>
    </message>
    <message>
        <source>How far below the bottom of the stock a cutter may go.</source>
        <translation>커터가 소재 바닥 아래로 내려가도 되는 거리.</translation>
    </message>
    <message>
        <source>Longer stretches of feeding in air are reported.</source>
        <translation>이보다 긴 공중 이송을 보고합니다.</translation>
    </message>
    <message>
        <source>Smallest loose piece</source>
        <translation>가장 작은 분리 조각</translation>
    </message>
    <message>
        <source>Smaller pieces that come loose count as chips.</source>
        <translation>이보다 작은 조각이 떨어지면 칩으로 봅니다.</translation>
    </message>
    <message>
        <source>Clearance of fixtures</source>
        <translation>고정구 간격</translation>
    </message>
    <message>
        <source>A tool that comes nearer to a fixture is reported, across and upwards.</source>
        <translation>고정구에 이보다 가까이 오는 공구를 보고합니다(옆과 위 방향).</translation>
    </message>
    <message>
        <source>Feed of taps</source>
        <translation>탭 이송</translation>
    </message>
    <message>
        <source>How far the feed of a tap may be from its pitch.</source>
        <translation>탭의 이송이 피치에서 벗어나도 되는 정도.</translation>
    </message>
    <message>
        <source>Clearance of rapids</source>
        <translation>급속 이송 간격</translation>
    </message>
    <message>
        <source>Rapids that pass less than this above the stock are reported; 0: none.</source>
        <translation>소재 위로 이보다 가까이 지나는 급속 이송을 보고합니다. 0: 보고하지 않음.</translation>
    </message>
    <message>
        <source>Travel X from</source>
        <translation>이동 범위 X 시작</translation>
    </message>
    <message>
        <source>Least machine coordinate of X; the same as the greatest: unknown, not checked.</source>
        <translation>X의 가장 작은 기계 좌표. 가장 큰 값과 같으면 알 수 없음(검사하지 않음).</translation>
    </message>
    <message>
        <source>Travel X to</source>
        <translation>이동 범위 X 끝</translation>
    </message>
    <message>
        <source>Greatest machine coordinate of X.</source>
        <translation>X의 가장 큰 기계 좌표.</translation>
    </message>
    <message>
        <source>Travel Y from</source>
        <translation>이동 범위 Y 시작</translation>
    </message>
    <message>
        <source>Least machine coordinate of Y; the same as the greatest: unknown, not checked.</source>
        <translation>Y의 가장 작은 기계 좌표. 가장 큰 값과 같으면 알 수 없음(검사하지 않음).</translation>
    </message>
    <message>
        <source>Travel Y to</source>
        <translation>이동 범위 Y 끝</translation>
    </message>
    <message>
        <source>Greatest machine coordinate of Y.</source>
        <translation>Y의 가장 큰 기계 좌표.</translation>
    </message>
    <message>
        <source>Travel Z from</source>
        <translation>이동 범위 Z 시작</translation>
    </message>
    <message>
        <source>Least machine coordinate of Z; the same as the greatest: unknown, not checked.</source>
        <translation>Z의 가장 작은 기계 좌표. 가장 큰 값과 같으면 알 수 없음(검사하지 않음).</translation>
    </message>
    <message>
        <source>Travel Z to</source>
        <translation>이동 범위 Z 끝</translation>
    </message>
    <message>
        <source>Greatest machine coordinate of Z.</source>
        <translation>Z의 가장 큰 기계 좌표.</translation>
    </message>
    <message>
        <source>Part zero X</source>
        <translation>공작물 원점 X</translation>
    </message>
    <message>
        <source>Machine coordinate X of X0 in the program, as in G54 of the control; all three 0: unknown.</source>
        <translation>프로그램 X0의 기계 좌표 X(컨트롤러의 G54 값). 셋 다 0이면 알 수 없음.</translation>
    </message>
    <message>
        <source>Part zero Y</source>
        <translation>공작물 원점 Y</translation>
    </message>
    <message>
        <source>Machine coordinate Y of Y0 in the program, as in G54 of the control.</source>
        <translation>프로그램 Y0의 기계 좌표 Y(컨트롤러의 G54 값).</translation>
    </message>
    <message>
        <source>Part zero Z</source>
        <translation>공작물 원점 Z</translation>
    </message>
    <message>
        <source>Machine coordinate Z with the face of the spindle at Z0 of the program.</source>
        <translation>주축 끝면이 프로그램 Z0에 있을 때의 기계 좌표 Z.</translation>
    </message>
    <message>
        <source>Router 600 × 400 × 100</source>
        <translation>라우터 600 × 400 × 100</translation>
    </message>
    <message>
        <source>Knee mill 760 × 400 × 125</source>
        <translation>니형 밀링 머신 760 × 400 × 125</translation>
    </message>
    <message>
        <source>Machining centre 500 × 400 × 500</source>
        <translation>머시닝 센터 500 × 400 × 500</translation>
    </message>
    <message>
        <source>Machining centre 760 × 400 × 500</source>
        <translation>머시닝 센터 760 × 400 × 500</translation>
    </message>
    <message>
        <source>Machining centre 1270 × 660 × 635</source>
        <translation>머시닝 센터 1270 × 660 × 635</translation>
    </message>
    <message>
        <source>Unknown machine profile</source>
        <translation>알 수 없는 기계 프로파일</translation>
    </message>
    <message>
        <source>The machine profile &quot;{}&quot; is unknown; the profiles are {}.</source>
        <translation>기계 프로파일 &quot;{}&quot;이(가) 없습니다. 있는 것: {}.</translation>
    </message>
    <message>
        <source>Begin with a profile, or write values only, as in rapidXY=20000.</source>
        <translation>프로파일로 시작하거나 rapidXY=20000처럼 값만 쓰십시오.</translation>
    </message>
    <message>
        <source>Waiver without its finding</source>
        <translation>항목이 없는 예외</translation>
    </message>
    <message>
        <source>The waiver of {} by {} ({}) has no effect: that finding is gone or has changed.</source>
        <translation>{} 항목에 대한 {}의 예외({})는 효력이 없습니다. 항목이 사라졌거나 바뀌었습니다.</translation>
    </message>
    <message>
        <source>Remove the waiver, or look at the finding and waive it again.</source>
        <translation>예외를 없애거나, 항목을 다시 확인하고 새로 예외 처리하십시오.</translation>
    </message>
    <message>
        <source>Waived</source>
        <translation>예외 처리됨</translation>
    </message>
    <message>
        <source>This does not count in the verdict: waived by {} ({}).</source>
        <translation>판정에 포함되지 않습니다: {}이(가) 예외 처리함({}).</translation>
    </message>
    <message>
        <source>Unknown rule in the job</source>
        <translation>작업의 알 수 없는 규칙</translation>
    </message>
    <message>
        <source>The job names “{}”, but nothing that is checked has this id.</source>
        <translation>작업이 “{}”을(를) 지정하지만, 이 ID를 가진 검사 항목이 없습니다.</translation>
    </message>
    <message>
        <source>Correct the id; “proveout-cli rules” lists all of them.</source>
        <translation>ID를 고치십시오. “proveout-cli rules”가 모든 ID를 보여 줍니다.</translation>
    </message>
    <message>
        <source>Beyond the travel</source>
        <translation>이동 범위 초과</translation>
    </message>
    <message>
        <source>{3} moves {1} mm beyond its travel limit, {2} mm in machine coordinates.</source>
        <translation>{3}이(가) 이동 한계(기계 좌표 {2} mm)를 {1} mm 넘습니다.</translation>
    </message>
    <message>
        <source>Place the part elsewhere, turn it, or shorten the motion.</source>
        <translation>공작물을 다른 곳에 놓거나 돌리거나, 이동을 줄이십시오.</translation>
    </message>
    <message>
        <source>Travel of Z with tools without a holder</source>
        <translation>홀더가 없는 공구의 Z 이동 범위</translation>
    </message>
    <message>
        <source>Jaw width</source>
        <translation>조 너비</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>열림 폭</translation>
    </message>
    <message>
        <source>Jaw height</source>
        <translation>조 높이</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>길이</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>너비</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>높이</translation>
    </message>
    <message>
        <source>Nut diameter</source>
        <translation>너트 지름</translation>
    </message>
    <message>
        <source>{}: unknown ({})</source>
        <translation>{}: 알 수 없음 ({})</translation>
    </message>
    <message>
        <source>{}: {} ({})</source>
        <translation>{}: {} ({})</translation>
    </message>
    <message>
        <source>Modal group: {}</source>
        <translation>모달 그룹: {}</translation>
    </message>
    <message>
        <source>Not supported: results after this block are unverified</source>
        <translation>지원하지 않음: 이 블록 이후의 결과는 검증되지 않습니다</translation>
    </message>
    <message>
        <source>Least X</source>
        <translation>최소 X</translation>
    </message>
    <message>
        <source>Least Y</source>
        <translation>최소 Y</translation>
    </message>
    <message>
        <source>Bottom Z</source>
        <translation>바닥 Z</translation>
    </message>
    <message>
        <source>Width (X)</source>
        <translation>너비 X</translation>
    </message>
    <message>
        <source>Depth (Y)</source>
        <translation>길이 Y</translation>
    </message>
    <message>
        <source>Axis X</source>
        <translation>축 X</translation>
    </message>
    <message>
        <source>Axis Y</source>
        <translation>축 Y</translation>
    </message>
    <message>
        <source>The waiver of {1} by {2} ({3}) has no effect: T{4} is now “{5}”, it was “{6}”.</source>
        <translation>{1} 항목에 대한 {2}의 예외({3})는 효력이 없습니다. T{4}는 현재 “{5}”이고, 이전에는 “{6}”이었습니다.</translation>
    </message>
    <message>
        <source>About its Z axis, counter-clockwise from above.</source>
        <translation>자체 Z축 기준, 위에서 볼 때 반시계 방향.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>배율</translation>
    </message>
    <message>
        <source>Millimetres in a unit of the file: 1, or 25.4 for inches.</source>
        <translation>파일 단위당 밀리미터: 1, 인치이면 25.4.</translation>
    </message>
    <message>
        <source>Zero X</source>
        <translation>원점 X</translation>
    </message>
    <message>
        <source>Zero Y</source>
        <translation>원점 Y</translation>
    </message>
    <message>
        <source>Zero Z</source>
        <translation>원점 Z</translation>
    </message>
    <message>
        <source>A fixture cannot have the shape &quot;{}&quot;; it can be a box, a cylinder or a mesh (stl).</source>
        <translation>고정구의 형상은 &quot;{}&quot;일 수 없습니다. 상자(box), 원기둥(cylinder) 또는 메시(stl)만 가능합니다.</translation>
    </message>
    <message>
        <source>Fixture without a file</source>
        <translation>파일 없는 고정구</translation>
    </message>
    <message>
        <source>A fixture of the shape &quot;stl&quot; needs the name of its file, as in stl:file=vice.stl.</source>
        <translation>형상이 &quot;stl&quot;인 고정구에는 파일 이름이 필요합니다(예: stl:file=vice.stl).</translation>
    </message>
    <message>
        <source>Fixture not checked</source>
        <translation>고정구 확인 안 됨</translation>
    </message>
    <message>
        <source>The fixture &quot;{}&quot; is not checked, because its file cannot be used: {}</source>
        <translation>고정구 &quot;{}&quot;의 파일을 사용할 수 없어 확인하지 않습니다. {}</translation>
    </message>
    <message>
        <source>Correct the file, or choose another one.</source>
        <translation>파일을 고치거나 다른 파일을 선택하십시오.</translation>
    </message>
    <message>
        <source>The file of the fixture has not been read.</source>
        <translation>고정구 파일을 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>The mesh has {} facets; a fixture can have {}.</source>
        <translation>메시의 면이 {}개입니다. 고정구는 {}개까지 가능합니다.</translation>
    </message>
    <message>
        <source>Simplify the mesh.</source>
        <translation>메시를 단순화하십시오.</translation>
    </message>
    <message>
        <source>The file has {}; that of a fixture can have {}.</source>
        <translation>파일 크기가 {}입니다. 고정구 파일은 {}까지 가능합니다.</translation>
    </message>
    <message>
        <source>The mesh has a coordinate beyond {} mm.</source>
        <translation>메시에 {}mm를 넘는 좌표가 있습니다.</translation>
    </message>
    <message>
        <source>Fixture with holes</source>
        <translation>구멍 난 고정구</translation>
    </message>
    <message>
        <source>The fixture &quot;{}&quot; is not checked where its mesh has holes: {}</source>
        <translation>고정구 &quot;{}&quot;는 메시에 구멍이 있는 곳을 확인하지 않습니다. {}</translation>
    </message>
    <message>
        <source>Export it again as one closed solid.</source>
        <translation>닫힌 솔리드 하나로 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>Clearance of holders</source>
        <translation>홀더 간격</translation>
    </message>
    <message>
        <source>A shank or holder that comes nearer to the stock is reported; 0: none.</source>
        <translation>섕크나 홀더가 소재에 이보다 가까워지면 보고합니다. 0: 보고 안 함.</translation>
    </message>
    <message>
        <source>Tool change X</source>
        <translation>공구 교환 X</translation>
    </message>
    <message>
        <source>Machine coordinate X that M6 needs; -1000000: any. Leave it if M6 itself moves there.</source>
        <translation>M6에 필요한 기계 좌표 X. -1000000: 제한 없음. M6이 직접 이동하면 그대로 두십시오.</translation>
    </message>
    <message>
        <source>Tool change Y</source>
        <translation>공구 교환 Y</translation>
    </message>
    <message>
        <source>The same for Y.</source>
        <translation>Y도 같습니다.</translation>
    </message>
    <message>
        <source>Tool change Z</source>
        <translation>공구 교환 Z</translation>
    </message>
    <message>
        <source>The same for Z, with the face of the spindle there.</source>
        <translation>Z도 같으며, 주축 단면 기준입니다.</translation>
    </message>
    <message>
        <source>Tool change elsewhere</source>
        <translation>다른 위치에서 공구 교환</translation>
    </message>
    <message>
        <source>{3} is {1} mm away from the tool change position, {2} mm in machine coordinates, when the tool is changed.</source>
        <translation>공구를 교환할 때 {3}축이 공구 교환 위치(기계 좌표 {2}mm)에서 {1}mm 떨어져 있습니다.</translation>
    </message>
    <message>
        <source>Move there before M6, for example with G28 or G53.</source>
        <translation>M6 전에 그 위치로 이동하십시오(예: G28 또는 G53).</translation>
    </message>
    <message>
        <source>Holder close to stock</source>
        <translation>소재에 가까운 홀더</translation>
    </message>
    <message>
        <source>The holder passes nearer than {2} mm to the stock, by {1} mm. To the sides, up to {3} mm of this may be due to the grid.</source>
        <translation>홀더가 소재에 {2}mm보다 {1}mm 더 가깝게 지나갑니다. 옆 방향으로는 이 중 최대 {3}mm가 격자 때문일 수 있습니다.</translation>
    </message>
    <message>
        <source>Extend the tool, choose a slimmer holder or a finer grid, or reduce holderClearance.</source>
        <translation>공구를 더 길게 물리거나, 더 가는 홀더 또는 더 촘촘한 격자를 선택하거나, holderClearance를 줄이십시오.</translation>
    </message>
    <message>
        <source>Shank close to stock</source>
        <translation>소재에 가까운 섕크</translation>
    </message>
    <message>
        <source>The shank passes nearer than {2} mm to the stock, by {1} mm. To the sides, up to {3} mm of this may be due to the grid.</source>
        <translation>섕크가 소재에 {2}mm보다 {1}mm 더 가깝게 지나갑니다. 옆 방향으로는 이 중 최대 {3}mm가 격자 때문일 수 있습니다.</translation>
    </message>
    <message>
        <source>Choose a tool with longer flutes or a finer grid, or reduce holderClearance.</source>
        <translation>날이 더 긴 공구나 더 촘촘한 격자를 선택하거나, holderClearance를 줄이십시오.</translation>
    </message>
    <message>
        <source>Walls at grid points</source>
        <translation>격자점에 놓인 벽</translation>
    </message>
    <message>
        <source>Use a finer grid for walls that are close together.</source>
        <translation>서로 가까운 벽에는 더 촘촘한 격자를 사용하십시오.</translation>
    </message>
    <message>
        <source>{} of {} points beside walls are at points of the grid in the file: the grid does not resolve the walls around them.</source>
        <translation>파일에서 벽 옆의 점 {}개(전체 {}개 중)가 격자점에 놓였습니다. 격자가 주변의 벽을 구분하지 못합니다.</translation>
    </message>
    <message>
        <source>Ribs between grid points</source>
        <translation>격자점 사이의 리브</translation>
    </message>
    <message>
        <source>Ribs thinner than the grid spacing are missing from the file: {} places between grid points, the first at X{} Y{}.</source>
        <translation>격자 간격보다 얇은 리브는 파일에 없습니다. {}곳에서 격자점 사이에 있으며 첫 위치는 X{} Y{}입니다.</translation>
    </message>
    <message>
        <source>Use a finer grid, or look at these places in a detail region.</source>
        <translation>더 촘촘한 격자를 사용하거나 상세 영역에서 이 위치를 확인하십시오.</translation>
    </message>
    <message>
        <source>GLB file too large</source>
        <translation>GLB 파일이 너무 큼</translation>
    </message>
    <message>
        <source>The mesh of {} triangles needs more than {} bytes, the most that a GLB file holds.</source>
        <translation>삼각형 {}개의 메시에는 GLB 파일의 최대 크기인 {}바이트보다 많은 공간이 필요합니다.</translation>
    </message>
    <message>
        <source>Export with a larger error allowance, or to another format.</source>
        <translation>허용 오차를 늘리거나 다른 형식으로 내보내십시오.</translation>
    </message>
    <message>
        <source>The vertex {}, {}, {} is out of the range of single precision.</source>
        <translation>꼭짓점 {}, {}, {}이(가) 단정밀도의 범위를 벗어났습니다.</translation>
    </message>
    <message>
        <source>GLB (glTF 2.0)</source>
        <translation>GLB (glTF 2.0)</translation>
    </message>
    <message>
        <source>Some walls in the file are at points of the grid: in {} of {} squares of 64 × 64 points, more than {} motions of the program are near the walls, or the walls of the stock are unknown.</source>
        <translation>파일의 일부 벽이 격자점에 놓였습니다. 64 × 64점 정사각형 {}개(전체 {}개 중)에서 프로그램의 이동이 {}개보다 많이 벽 가까이를 지나거나, 소재의 벽이 알려져 있지 않습니다.</translation>
    </message>
    <message>
        <source>Use a finer grid, so that fewer motions are over each square, or a stock whose walls are known.</source>
        <translation>각 정사각형을 지나는 이동이 줄어들도록 더 촘촘한 격자를 사용하거나, 벽이 알려진 소재를 사용하십시오.</translation>
    </message>
    <message>
        <source>Stock walls at grid points</source>
        <translation>소재의 벽이 격자점에 있음</translation>
    </message>
    <message>
        <source>The walls of the saved stock are at grid points: they are known on its own grid, with a spacing of {} × {} mm, and with its own height only.</source>
        <translation>저장된 소재의 벽이 격자점에 놓였습니다. 벽은 간격 {} × {} mm인 소재 자체의 격자와 소재 자체의 높이에서만 알려져 있습니다.</translation>
    </message>
    <message>
        <source>Use the spacing and the height of the saved stock to keep its walls.</source>
        <translation>벽을 유지하려면 저장된 소재의 간격과 높이를 사용하십시오.</translation>
    </message>
    <message>
        <source>The walls of the stock mesh are at grid points: more than {} of its triangles, on average, are over one place, too many to find walls between the points.</source>
        <translation>소재 메시의 벽이 격자점에 놓였습니다. 한 위치에 평균 {}개보다 많은 삼각형이 있어 격자점 사이의 벽을 찾을 수 없습니다.</translation>
    </message>
    <message>
        <source>Export the stock with triangles that are less long and narrow.</source>
        <translation>덜 길고 좁은 삼각형으로 소재를 내보내십시오.</translation>
    </message>
    <message>
        <source>Unknown key of part</source>
        <translation>알 수 없는 설계 형상 항목</translation>
    </message>
    <message>
        <source>The design part has no &quot;{}&quot;; it has {}.</source>
        <translation>설계 형상에는 &quot;{}&quot; 항목이 없습니다. 있는 항목: {}.</translation>
    </message>
    <message>
        <source>Invalid value of part</source>
        <translation>잘못된 설계 형상 값</translation>
    </message>
    <message>
        <source>&quot;{}&quot; of the design part must be a number from {} to {}.</source>
        <translation>설계 형상의 &quot;{}&quot;은(는) {}에서 {}까지의 수여야 합니다.</translation>
    </message>
    <message>
        <source>Part without a file</source>
        <translation>파일이 없는 설계 형상</translation>
    </message>
    <message>
        <source>The design part needs the name of its file, as in x=0,y=0,z=0,file=part.stl.</source>
        <translation>설계 형상에는 x=0,y=0,z=0,file=part.stl처럼 파일 이름이 필요합니다.</translation>
    </message>
    <message>
        <source>Part not compared</source>
        <translation>설계 형상 비교 안 됨</translation>
    </message>
    <message>
        <source>The stock is not compared with the part, because its file cannot be used: {}</source>
        <translation>설계 형상 파일을 사용할 수 없어 소재를 비교하지 않습니다: {}</translation>
    </message>
    <message>
        <source>The program is checked without a stock, so there is nothing to compare with the part.</source>
        <translation>소재 없이 프로그램을 검사하므로 설계 형상과 비교할 것이 없습니다.</translation>
    </message>
    <message>
        <source>State the stock.</source>
        <translation>소재를 지정하십시오.</translation>
    </message>
    <message>
        <source>Format of part unknown</source>
        <translation>알 수 없는 설계 형상 형식</translation>
    </message>
    <message>
        <source>A design part cannot be read from a file that ends in &quot;{}&quot;.</source>
        <translation>&quot;{}&quot; 확장자의 파일에서는 설계 형상을 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>Export the part as STL.</source>
        <translation>설계 형상을 STL로 내보내십시오.</translation>
    </message>
    <message>
        <source>Part too large</source>
        <translation>설계 형상이 너무 큼</translation>
    </message>
    <message>
        <source>The part needs {}; {} are available.</source>
        <translation>설계 형상에 {}이(가) 필요하지만 {}만 사용할 수 있습니다.</translation>
    </message>
    <message>
        <source>Export the part with fewer facets.</source>
        <translation>면 수를 줄여 설계 형상을 내보내십시오.</translation>
    </message>
    <message>
        <source>Part turned over in places</source>
        <translation>설계 형상의 면 방향 불일치</translation>
    </message>
    <message>
        <source>Neighbouring facets of the part face to opposite sides at {} edges, so that inside and outside are not known.</source>
        <translation>설계 형상의 모서리 {}곳에서 이웃한 면의 방향이 반대여서 안쪽과 바깥쪽을 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Part repaired</source>
        <translation>설계 형상 수정됨</translation>
    </message>
    <message>
        <source>The part is inside out; all {} facets were turned over.</source>
        <translation>설계 형상의 안팎이 뒤집혀 있어 면 {}개를 모두 뒤집었습니다.</translation>
    </message>
    <message>
        <source>{} facets of the part are there twice; one of each was left out.</source>
        <translation>설계 형상의 면 {}개가 중복되어 하나씩 제외했습니다.</translation>
    </message>
    <message>
        <source>Part not closed</source>
        <translation>닫히지 않은 설계 형상</translation>
    </message>
    <message>
        <source>The part is not closed at {} edges; places next to them are not judged.</source>
        <translation>설계 형상이 모서리 {}곳에서 닫혀 있지 않아 그 옆은 판정하지 않습니다.</translation>
    </message>
    <message>
        <source>Part touches itself</source>
        <translation>서로 닿는 설계 형상</translation>
    </message>
    <message>
        <source>At {} edges of the part more than two facets meet.</source>
        <translation>설계 형상의 모서리 {}곳에서 면이 셋 이상 만납니다.</translation>
    </message>
    <message>
        <source>Part gouged</source>
        <translation>설계 형상 과절삭</translation>
    </message>
    <message>
        <source>The tool cuts {} mm into the part; {} mm are allowed.</source>
        <translation>공구가 설계 형상을 {} mm 파고듭니다. 허용값은 {} mm입니다.</translation>
    </message>
    <message>
        <source>Correct the toolpath, the tool or its length, or allow more.</source>
        <translation>공구 경로, 공구 또는 공구 길이를 고치거나 허용값을 늘리십시오.</translation>
    </message>
    <message>
        <source>Stock left on part</source>
        <translation>설계 형상의 미절삭</translation>
    </message>
    <message>
        <source>{} mm of stock are left on the part; {} mm are allowed.</source>
        <translation>설계 형상에 소재가 {} mm 남습니다. 허용값은 {} mm입니다.</translation>
    </message>
    <message>
        <source>Machine what is left, or state the allowance if it is to stay.</source>
        <translation>남은 부분을 가공하거나, 남겨야 한다면 가공 여유를 지정하십시오.</translation>
    </message>
    <message>
        <source>{} mm of the part are missing where no tool cuts; {} mm are allowed.</source>
        <translation>공구가 가공하지 않은 곳에서 설계 형상이 {} mm 모자랍니다. 허용값은 {} mm입니다.</translation>
    </message>
    <message>
        <source>Check the size and the position of the stock and of the part.</source>
        <translation>소재와 설계 형상의 크기와 위치를 확인하십시오.</translation>
    </message>
    <message>
        <source>Part outside of stock</source>
        <translation>소재를 벗어난 설계 형상</translation>
    </message>
    <message>
        <source>The part reaches {} mm beyond the stock ({}); it is not compared there.</source>
        <translation>설계 형상이 소재를 {} mm 벗어납니다({}). 그 부분은 비교하지 않습니다.</translation>
    </message>
    <message>
        <source>Check the position of the part, its unit, and the stock.</source>
        <translation>설계 형상의 위치와 단위, 소재를 확인하십시오.</translation>
    </message>
    <message>
        <source>Part misplaced</source>
        <translation>잘못 놓인 설계 형상</translation>
    </message>
    <message>
        <source>Only {} % of the part are within the stock: it is not compared.</source>
        <translation>설계 형상의 {} %만 소재 안에 있어 비교하지 않습니다.</translation>
    </message>
    <message>
        <source>Inside of part unknown</source>
        <translation>설계 형상의 안쪽을 알 수 없음</translation>
    </message>
    <message>
        <source>At {} points the mesh does not tell whether they are inside or outside of the part.</source>
        <translation>점 {}개가 설계 형상의 안쪽인지 바깥쪽인지 메시로 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Export the part again as one closed solid without overlapping bodies.</source>
        <translation>겹치는 물체 없이 하나의 닫힌 솔리드로 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>Walls not resolved</source>
        <translation>분해되지 않은 벽</translation>
    </message>
    <message>
        <source>{} mm² of the steep faces of the part cannot be judged at this grid spacing.</source>
        <translation>이 격자 간격으로는 설계 형상의 가파른 면 {} mm²를 판정할 수 없습니다.</translation>
    </message>
    <message>
        <source>Choose a finer grid, or a wider tolerance.</source>
        <translation>더 촘촘한 격자나 더 큰 공차를 선택하십시오.</translation>
    </message>
    <message>
        <source>Thin ribs are left at {} places between the points of the grid, and are not compared.</source>
        <translation>격자점 사이 {}곳에 얇은 리브가 남으며 비교하지 않습니다.</translation>
    </message>
    <message>
        <source>Choose a finer grid.</source>
        <translation>더 촘촘한 격자를 선택하십시오.</translation>
    </message>
    <message>
        <source>Undercut of part</source>
        <translation>설계 형상의 언더컷</translation>
    </message>
    <message>
        <source>{} mm² of the part are below other faces of it, where no tool reaches them along Z; stock is left there.</source>
        <translation>설계 형상의 {} mm²가 다른 면 아래에 있어 공구가 Z 방향으로 닿지 않으며 소재가 남습니다.</translation>
    </message>
    <message>
        <source>Program coordinate of the zero of the part&apos;s file.</source>
        <translation>설계 형상 파일 원점의 프로그램 좌표.</translation>
    </message>
    <message>
        <source>May be missing</source>
        <translation>과절삭 허용</translation>
    </message>
    <message>
        <source>Tolerance into the part, normal to its surface; more is a gouge.</source>
        <translation>표면에 수직으로 설계 형상 안쪽 공차. 넘으면 과절삭입니다.</translation>
    </message>
    <message>
        <source>May be left</source>
        <translation>미절삭 허용</translation>
    </message>
    <message>
        <source>Tolerance outside of the part, normal to its surface; more is excess.</source>
        <translation>표면에 수직으로 설계 형상 바깥쪽 공차. 넘으면 미절삭입니다.</translation>
    </message>
    <message>
        <source>Stock allowance</source>
        <translation>가공 여유</translation>
    </message>
    <message>
        <source>Stock that the program is to leave on the part, as for finishing; deviations count from it.</source>
        <translation>정삭 등을 위해 프로그램이 설계 형상에 남겨야 하는 소재. 편차는 여기서부터 셉니다.</translation>
    </message>
</context>
<context>
    <name>CycleTime</name>
    <message>
        <source>Cycle time to this block / of the program</source>
        <translation>이 블록까지의 가공 시간 / 전체 가공 시간</translation>
    </message>
    <message>
        <source>Feed %1, rapid %2, dwell %3, tool changes %4</source>
        <translation>절삭 %1, 급속 %2, 드웰 %3, 공구 교환 %4</translation>
    </message>
    <message>
        <source>Default machine values; enter those of your machine in the Setup panel.</source>
        <translation>기본 기계 값입니다. 셋업 패널에서 실제 기계의 값을 입력하십시오.</translation>
    </message>
    <message>
        <source>%1 moves have no feed rate; the maximum is assumed.</source>
        <translation>이송 속도가 없는 동작 %1개는 최대 이송 속도로 가정합니다.</translation>
    </message>
</context>
<context>
    <name>DeviationChart</name>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>점 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>below %1 mm: %2</source>
        <translation>%1 mm 미만: %2</translation>
    </message>
    <message>
        <source>above %1 mm: %2</source>
        <translation>%1 mm 초과: %2</translation>
    </message>
    <message>
        <source>%1 to %2 mm: %3</source>
        <translation>%1~%2 mm: %3</translation>
    </message>
</context>
<context>
    <name>DockTitles</name>
    <message>
        <source>Float or dock this panel</source>
        <translation>이 패널을 띄우거나 고정합니다</translation>
    </message>
    <message>
        <source>Close this panel</source>
        <translation>이 패널을 닫습니다</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>NC Program</source>
        <translation>NC 프로그램</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>셋업</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>조정</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>그래프</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>문제</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>타임라인</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>연구</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>제어기</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>중단점</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>설계 형상</translation>
    </message>
</context>
<context>
    <name>DocumentTitle</name>
    <message>
        <source>untitled</source>
        <translation>제목 없음</translation>
    </message>
    <message>
        <source>setup</source>
        <translation>셋업</translation>
    </message>
</context>
<context>
    <name>EditCommands</name>
    <message>
        <source>&amp;Undo</source>
        <translation>실행 취소(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>다시 실행(&amp;R)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>잘라내기(&amp;T)</translation>
    </message>
    <message>
        <source>Move the selected text to the clipboard</source>
        <translation>선택한 텍스트를 클립보드로 옮깁니다</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>복사(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the selected text to the clipboard</source>
        <translation>선택한 텍스트를 클립보드에 복사합니다</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>붙여넣기(&amp;P)</translation>
    </message>
    <message>
        <source>Insert the text from the clipboard</source>
        <translation>클립보드의 텍스트를 넣습니다</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>삭제(&amp;D)</translation>
    </message>
    <message>
        <source>Delete the selected text</source>
        <translation>선택한 텍스트를 지웁니다</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>모두 선택(&amp;A)</translation>
    </message>
    <message>
        <source>Select all of the text</source>
        <translation>텍스트 전체를 선택합니다</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>찾기(&amp;F)…</translation>
    </message>
    <message>
        <source>Find text in the NC program</source>
        <translation>NC 프로그램에서 텍스트를 찾습니다</translation>
    </message>
    <message>
        <source>R&amp;eplace…</source>
        <translation>바꾸기(&amp;E)…</translation>
    </message>
    <message>
        <source>Find text in the NC program and replace it</source>
        <translation>NC 프로그램에서 텍스트를 찾아 바꿉니다</translation>
    </message>
    <message>
        <source>Find &amp;Next</source>
        <translation>다음 찾기(&amp;N)</translation>
    </message>
    <message>
        <source>Go to the next match</source>
        <translation>다음 일치 항목으로 이동합니다</translation>
    </message>
    <message>
        <source>Find Pre&amp;vious</source>
        <translation>이전 찾기(&amp;V)</translation>
    </message>
    <message>
        <source>Go to the previous match</source>
        <translation>이전 일치 항목으로 이동합니다</translation>
    </message>
    <message>
        <source>Run to Cur&amp;sor</source>
        <translation>커서까지 실행(&amp;S)</translation>
    </message>
    <message>
        <source>Show the stock after the cursor line</source>
        <translation>커서가 있는 줄까지 가공한 소재를 표시합니다</translation>
    </message>
    <message>
        <source>Toggle &amp;Breakpoint</source>
        <translation>중단점 전환(&amp;B)</translation>
    </message>
    <message>
        <source>Set or remove a breakpoint at the cursor line</source>
        <translation>커서가 있는 줄에 중단점을 설정하거나 제거합니다</translation>
    </message>
    <message>
        <source>Undo the last change where the focus is: program text, or setup, tuning and machine</source>
        <translation>포커스가 있는 곳(텍스트 또는 셋업, 조정, 기계)의 마지막 변경을 실행 취소합니다</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>마지막으로 실행 취소한 변경을 다시 실행합니다</translation>
    </message>
</context>
<context>
    <name>EditedElsewhereBar</name>
    <message>
        <source>%1 has unsaved changes in another Proveout window (process %2 on %3). Save or discard them there before you edit the file here.</source>
        <translation>다른 Proveout 창(%3의 프로세스 %2)에 %1의 저장하지 않은 변경이 있습니다. 여기서 파일을 편집하기 전에 그 창에서 저장하거나 버리십시오.</translation>
    </message>
</context>
<context>
    <name>EditorPanel</name>
    <message>
        <source>NC program</source>
        <translation>NC 프로그램</translation>
    </message>
    <message>
        <source>Read-only, with lines truncated: line %1 has more than %2 characters.</source>
        <translation>읽기 전용이며 줄을 잘라 표시합니다. %1번째 줄이 %2자를 넘습니다.</translation>
    </message>
    <message>
        <source>Read-only: the file is larger than 1 GB.</source>
        <translation>읽기 전용: 파일이 1 GB보다 큽니다.</translation>
    </message>
    <message>
        <source>F&amp;ollow Program</source>
        <translation>프로그램 따라가기(&amp;O)</translation>
    </message>
    <message>
        <source>Keep the current line in view during playback; typing, clicking or scrolling in the text turns this off until playback is restarted</source>
        <translation>프로그램을 재생하는 동안 현재 줄이 보이도록 유지합니다. 텍스트에서 입력, 클릭 또는 스크롤하면 재생을 다시 시작할 때까지 꺼집니다</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>full resolution, largest error %1 mm</source>
        <translation>전체 해상도, 최대 오차 %1 mm</translation>
    </message>
    <message>
        <source>largest measured error %1 mm, not guaranteed</source>
        <translation>측정된 최대 오차 %1 mm, 보장되지 않음</translation>
    </message>
    <message>
        <source>largest error %1 mm exceeds the allowance of %2 mm</source>
        <translation>최대 오차 %1 mm, 허용 오차 %2 mm 초과</translation>
    </message>
    <message>
        <source>largest error %1 mm, certified within %2 mm at every z-map point</source>
        <translation>최대 오차 %1 mm, 모든 Z맵 점에서 %2 mm 이내 보증</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>%1 파일이 이미 있습니다. 바꿀까요?</translation>
    </message>
    <message>
        <source>Exported %1: %2</source>
        <translation>%1 내보냄: %2</translation>
    </message>
    <message>
        <source>%1: %2 triangles, %3</source>
        <translation>%1: 삼각형 %2개, %3</translation>
    </message>
    <message>
        <source>largest error %1 mm, certified within %2 mm everywhere</source>
        <translation>최대 오차 %1 mm, 모든 곳에서 %2 mm 이내로 보증됨</translation>
    </message>
    <message>
        <source>(block %1 of %2)</source>
        <translation>(블록 %1/%2)</translation>
    </message>
    <message>
        <source>Saved %1: the stock for the next setup</source>
        <translation>%1 저장됨: 다음 셋업의 소재</translation>
    </message>
    <message>
        <source>largest error %1 mm, certified within %2 mm everywhere but at walls</source>
        <translation>최대 오차 %1 mm, 벽을 제외한 모든 곳에서 %2 mm 이내로 보증됨</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Range: %1 to %2</source>
        <comment>the second one with its unit</comment>
        <translation>범위: %1~%2</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>기본값: %1</translation>
    </message>
</context>
<context>
    <name>FileChangedBar</name>
    <message>
        <source>Read the file again; your unsaved changes are lost</source>
        <translation>파일을 다시 읽습니다. 저장하지 않은 변경은 없어집니다</translation>
    </message>
    <message>
        <source>%1 was deleted or renamed on disk. Saving creates it again.</source>
        <translation>디스크에서 %1이(가) 삭제되었거나 이름이 바뀌었습니다. 저장하면 다시 만듭니다.</translation>
    </message>
    <message>
        <source>%1 is no longer a file. Save under another name.</source>
        <translation>%1은(는) 더 이상 파일이 아닙니다. 다른 이름으로 저장하십시오.</translation>
    </message>
    <message>
        <source>%1 has changed on disk. Reloading discards your unsaved changes.</source>
        <translation>디스크에서 %1이(가) 변경되었습니다. 다시 읽으면 저장하지 않은 변경을 잃습니다.</translation>
    </message>
    <message>
        <source>%1 has changed on disk.</source>
        <translation>디스크에서 %1이(가) 변경되었습니다.</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>다시 읽기(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Keep My Version</source>
        <translation>내 버전 유지(&amp;K)</translation>
    </message>
    <message>
        <source>Continue with the version in this window</source>
        <translation>이 창의 버전으로 계속합니다</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>비교(&amp;C)…</translation>
    </message>
    <message>
        <source>Show the differences between the file and this window</source>
        <translation>파일과 이 창의 차이를 표시합니다</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New</source>
        <translation>새로 만들기(&amp;N)</translation>
    </message>
    <message>
        <source>Create an empty NC program</source>
        <translation>빈 NC 프로그램을 만듭니다</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>열기(&amp;O)…</translation>
    </message>
    <message>
        <source>Open an NC program or a job</source>
        <translation>NC 프로그램이나 작업을 엽니다</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>저장(&amp;S)</translation>
    </message>
    <message>
        <source>Save the NC program, and its job if it has one</source>
        <translation>NC 프로그램과, 있으면 그 작업을 저장합니다</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>다른 이름으로 저장(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the NC program under another name</source>
        <translation>NC 프로그램을 다른 이름으로 저장합니다</translation>
    </message>
    <message>
        <source>Save &amp;Job As…</source>
        <translation>작업을 다른 이름으로 저장(&amp;J)…</translation>
    </message>
    <message>
        <source>Save stock, tools and parameters of the program as a job</source>
        <translation>프로그램의 소재, 공구, 파라미터를 작업으로 저장합니다</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>끝내기(&amp;Q)</translation>
    </message>
    <message>
        <source>Close Proveout</source>
        <translation>Proveout을 닫습니다</translation>
    </message>
    <message>
        <source>Save S&amp;tock…</source>
        <translation>소재 저장(&amp;T)…</translation>
    </message>
    <message>
        <source>Save the remaining stock for the next setup</source>
        <translation>남은 소재를 다음 셋업용으로 저장합니다</translation>
    </message>
</context>
<context>
    <name>FileFlow</name>
    <message>
        <source>Open</source>
        <translation>열기</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>모든 파일 (*)</translation>
    </message>
    <message>
        <source>Save NC Program As</source>
        <translation>NC 프로그램을 다른 이름으로 저장</translation>
    </message>
    <message>
        <source>Save Job As</source>
        <translation>작업을 다른 이름으로 저장</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>저장하지 않은 변경</translation>
    </message>
    <message>
        <source>Drop a single file from this computer.</source>
        <translation>이 컴퓨터의 파일 하나를 끌어다 놓으십시오.</translation>
    </message>
    <message>
        <source>A folder cannot be opened; drop an NC program or a job.</source>
        <translation>폴더는 열 수 없습니다. NC 프로그램이나 작업을 끌어다 놓으십시오.</translation>
    </message>
    <message>
        <source>A mesh is not a program. To cut it, choose it as the stock in the Setup panel.</source>
        <translation>메시는 프로그램이 아닙니다. 가공하려면 셋업 패널에서 소재로 선택하십시오.</translation>
    </message>
    <message>
        <source>Export Decimated Mesh</source>
        <translation>간략화된 메시 내보내기</translation>
    </message>
    <message>
        <source>Export Full-Resolution Mesh</source>
        <translation>전체 해상도 메시 내보내기</translation>
    </message>
    <message>
        <source>Export in progress</source>
        <translation>내보내기 진행 중</translation>
    </message>
    <message>
        <source>A file is still being written.</source>
        <translation>파일을 아직 쓰는 중입니다.</translation>
    </message>
    <message>
        <source>Close after the file is written, or discard the file and close now?</source>
        <translation>파일을 다 쓴 뒤에 닫을까요, 아니면 파일을 버리고 지금 닫을까요?</translation>
    </message>
    <message>
        <source>&amp;Wait for the File</source>
        <translation>파일을 기다리기(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Discard the File</source>
        <translation>파일 버리기(&amp;D)</translation>
    </message>
    <message>
        <source>Save Stock</source>
        <translation>소재 저장</translation>
    </message>
    <message>
        <source>Saved as %1; the other version is still in %2.</source>
        <translation>%1(으)로 저장했습니다. 다른 버전은 %2에 남아 있습니다.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 저장됨</translation>
    </message>
    <message>
        <source>. The setup has not been saved as a job.</source>
        <translation>. 셋업은 작업으로 저장되지 않았습니다.</translation>
    </message>
    <message>
        <source>The new program has not been saved.</source>
        <translation>새 프로그램이 저장되지 않았습니다.</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1에 저장하지 않은 변경이 있습니다.</translation>
    </message>
    <message>
        <source>The setup has not been saved as a job.</source>
        <translation>셋업이 작업으로 저장되지 않았습니다.</translation>
    </message>
    <message>
        <source>The setup of %1 has unsaved changes.</source>
        <translation>%1의 셋업에 저장하지 않은 변경이 있습니다.</translation>
    </message>
    <message>
        <source>Save the changes first?</source>
        <translation>먼저 변경 내용을 저장할까요?</translation>
    </message>
    <message>
        <source>NC programs and jobs (%1)</source>
        <translation>NC 프로그램과 작업 (%1)</translation>
    </message>
</context>
<context>
    <name>FindBar</name>
    <message>
        <source>Replacing…</source>
        <translation>바꾸는 중…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>찾기</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>바꿀 내용</translation>
    </message>
    <message>
        <source>Previous match (Shift+F3)</source>
        <translation>이전 일치 항목(Shift+F3)</translation>
    </message>
    <message>
        <source>Previous match</source>
        <translation>이전 일치 항목</translation>
    </message>
    <message>
        <source>Next match (F3)</source>
        <translation>다음 일치 항목(F3)</translation>
    </message>
    <message>
        <source>Next match</source>
        <translation>다음 일치 항목</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>바꾸기</translation>
    </message>
    <message>
        <source>All</source>
        <translation>모두</translation>
    </message>
    <message>
        <source>Replace all matches</source>
        <translation>일치 항목을 모두 바꿉니다</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>닫기(Esc)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Not found.</source>
        <translation>찾지 못했습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n replaced.</source>
        <translation>
            <numerusform>%n개를 바꾸었습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Whole words</source>
        <translation>온전한 워드</translation>
    </message>
    <message>
        <source>Find G2 in G2X10, but not in G21 or G2.1</source>
        <translation>G2X10의 G2는 찾고 G21이나 G2.1은 찾지 않습니다</translation>
    </message>
    <message>
        <source>more than %1</source>
        <comment>matches</comment>
        <translation>%1개 초과</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>matches</comment>
        <translation>%2 중 %1</translation>
    </message>
    <message>
        <source>%1 found</source>
        <comment>matches</comment>
        <translation>%1개 찾음</translation>
    </message>
</context>
<context>
    <name>FixtureEditor</name>
    <message>
        <source>Vice</source>
        <translation>바이스</translation>
    </message>
    <message>
        <source>Step clamp</source>
        <translation>단차 클램프</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>직육면체</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>원통</translation>
    </message>
    <message>
        <source>Vice…</source>
        <translation>바이스…</translation>
    </message>
    <message>
        <source>Step Clamp…</source>
        <translation>단차 클램프…</translation>
    </message>
    <message>
        <source>Bed</source>
        <translation>베드</translation>
    </message>
    <message>
        <source>Moving jaw</source>
        <translation>가동 조</translation>
    </message>
    <message>
        <source>Fixed jaw</source>
        <translation>고정 조</translation>
    </message>
    <message>
        <source>Bolt</source>
        <translation>볼트</translation>
    </message>
    <message>
        <source>Clamp</source>
        <translation>클램프</translation>
    </message>
    <message>
        <source>There is already a fixture &quot;%1&quot;.</source>
        <translation>&quot;%1&quot; 고정구가 이미 있습니다.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>크기</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>고정구</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>추가</translation>
    </message>
    <message>
        <source>Add a fixture at the stock</source>
        <translation>소재 옆에 고정구를 추가합니다</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>복사</translation>
    </message>
    <message>
        <source>Add a copy of the selected fixture</source>
        <translation>선택한 고정구의 사본을 추가합니다</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>제거</translation>
    </message>
    <message>
        <source>Remove the selected fixture</source>
        <translation>선택한 고정구를 제거합니다</translation>
    </message>
    <message>
        <source>Name of the fixture</source>
        <translation>고정구 이름</translation>
    </message>
    <message>
        <source>Findings name the fixture like this</source>
        <translation>검사 결과에 이 이름으로 표시됩니다</translation>
    </message>
    <message>
        <source>Mesh (STL)…</source>
        <translation>메시(STL)…</translation>
    </message>
    <message>
        <source>Mesh of a Fixture</source>
        <translation>고정구 메시</translation>
    </message>
    <message>
        <source>Mesh (%1)</source>
        <translation>메시(%1)</translation>
    </message>
    <message>
        <source>Not read</source>
        <translation>읽지 않음</translation>
    </message>
</context>
<context>
    <name>ForeignNotice</name>
    <message>
        <source>Read As</source>
        <translation>다음으로 읽기</translation>
    </message>
    <message>
        <source>Choose the dialect of the program</source>
        <translation>프로그램의 제어기 방식을 선택합니다</translation>
    </message>
</context>
<context>
    <name>GridField</name>
    <message>
        <source>Automatic</source>
        <translation>자동</translation>
    </message>
    <message>
        <source>Automatic grid spacing</source>
        <translation>자동 격자 간격</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>자동</translation>
    </message>
</context>
<context>
    <name>GuideWindow</name>
    <message>
        <source>User Guide – Proveout</source>
        <translation>사용 설명서 – Proveout</translation>
    </message>
    <message>
        <source>← Back</source>
        <translation>← 뒤로</translation>
    </message>
    <message>
        <source>Forward →</source>
        <translation>앞으로 →</translation>
    </message>
    <message>
        <source>User guide pages</source>
        <translation>사용 설명서의 페이지 목록</translation>
    </message>
    <message>
        <source>User guide page</source>
        <translation>사용 설명서의 페이지</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>&amp;User Guide</source>
        <translation>사용 설명서(&amp;U)</translation>
    </message>
    <message>
        <source>Show the page about the panel that has the focus</source>
        <translation>포커스가 있는 패널에 관한 설명을 표시합니다</translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation>키와 마우스(&amp;K)</translation>
    </message>
    <message>
        <source>List all keyboard shortcuts and mouse actions</source>
        <translation>모든 단축키와 마우스 동작을 표시합니다</translation>
    </message>
    <message>
        <source>&amp;Start Page</source>
        <translation>시작 페이지(&amp;S)</translation>
    </message>
    <message>
        <source>Show samples and recent files</source>
        <translation>예제와 최근 파일을 표시합니다</translation>
    </message>
    <message>
        <source>&amp;About Proveout</source>
        <translation>Proveout 정보(&amp;A)</translation>
    </message>
    <message>
        <source>Version, licence and the paper</source>
        <translation>버전, 라이선스, 논문</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Qt 정보(&amp;Q)</translation>
    </message>
    <message>
        <source>About the user interface library</source>
        <translation>사용자 인터페이스 라이브러리 정보</translation>
    </message>
</context>
<context>
    <name>IgnoredCodesField</name>
    <message>
        <source>M%1 (%2×)</source>
        <translation>M%1(%2회)</translation>
    </message>
    <message>
        <source>M%1 %2 (%3×)</source>
        <translation>M%1 %2(%3회)</translation>
    </message>
    <message>
        <source>Ignored in this program: %1</source>
        <translation>이 프로그램에서 무시됨: %1</translation>
    </message>
    <message>
        <source>for example 16, 24, 25</source>
        <translation>예: 16, 24, 25</translation>
    </message>
</context>
<context>
    <name>IslandsModel</name>
    <message>
        <source>Kind</source>
        <translation>종류</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>깊이, mm</translation>
    </message>
    <message>
        <source>Area, mm²</source>
        <translation>면적, mm²</translation>
    </message>
    <message>
        <source>Volume, mm³</source>
        <translation>부피, mm³</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>행</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>공구</translation>
    </message>
</context>
<context>
    <name>JobSteps</name>
    <message>
        <source>Tool T%1</source>
        <translation>공구 T%1</translation>
    </message>
    <message>
        <source>Tool table</source>
        <translation>공구 테이블</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>소재</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>셋업</translation>
    </message>
    <message>
        <source>Decimation method</source>
        <translation>간략화 방법</translation>
    </message>
    <message>
        <source>Decimation parameters</source>
        <translation>간략화 파라미터</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>기계</translation>
    </message>
    <message>
        <source>Limits of rules</source>
        <translation>규칙의 한계값</translation>
    </message>
    <message>
        <source>Rules</source>
        <translation>규칙</translation>
    </message>
    <message>
        <source>Waiver</source>
        <translation>예외</translation>
    </message>
    <message>
        <source>Fixture %1</source>
        <translation>고정구 %1</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>고정구</translation>
    </message>
    <message>
        <source>Design part</source>
        <translation>설계 형상</translation>
    </message>
</context>
<context>
    <name>Layouts</name>
    <message>
        <source>&amp;Machinist</source>
        <translation>가공 작업자(&amp;M)</translation>
    </message>
    <message>
        <source>Program, setup and problems in front; playback in machine time</source>
        <translation>프로그램, 셋업, 문제를 앞에 표시하고 기계 시간으로 재생합니다</translation>
    </message>
    <message>
        <source>&amp;Research</source>
        <translation>연구(&amp;R)</translation>
    </message>
    <message>
        <source>Tuning and plots in front; playback by blocks</source>
        <translation>조정과 그래프를 앞에 표시하고 블록 단위로 재생합니다</translation>
    </message>
</context>
<context>
    <name>MachineForm</name>
    <message>
        <source>Default machine values.</source>
        <translation>기본 기계 값입니다.</translation>
    </message>
    <message>
        <source>Cycle time %1: feed %2, rapid %3, dwell %4, tool changes %5</source>
        <translation>가공 시간 %1: 절삭 %2, 급속 %3, 드웰 %4, 공구 교환 %5</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>프로파일</translation>
    </message>
    <message>
        <source>Typical machines by kind and size, to begin with</source>
        <translation>종류와 크기별 대표 기계(시작값)</translation>
    </message>
    <message>
        <source>any</source>
        <translation>제한 없음</translation>
    </message>
</context>
<context>
    <name>MemoryMenu</name>
    <message>
        <source>%1 (default)</source>
        <translation>%1(기본값)</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>파일(&amp;F)</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>최근 파일 열기(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>편집(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>보기(&amp;V)</translation>
    </message>
    <message>
        <source>P&amp;lots</source>
        <translation>그래프(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>시뮬레이션(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Mesh</source>
        <translation>메시(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>창(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>테마(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>언어(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>도움말(&amp;H)</translation>
    </message>
    <message>
        <source>Open Sa&amp;mple</source>
        <translation>예제 열기(&amp;M)</translation>
    </message>
    <message>
        <source>Rewind &amp;Memory</source>
        <translation>되감기 메모리(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Graphics Memory</source>
        <translation>그래픽 메모리(&amp;G)</translation>
    </message>
    <message>
        <source>L&amp;ayout</source>
        <translation>배치(&amp;A)</translation>
    </message>
</context>
<context>
    <name>MeshCommands</name>
    <message>
        <source>Export the decimated mesh as a closed solid</source>
        <translation>간략화된 메시를 닫힌 솔리드로 내보냅니다</translation>
    </message>
    <message>
        <source>Export the mesh with every z-map point</source>
        <translation>모든 Z맵 점을 포함한 메시를 내보냅니다</translation>
    </message>
    <message>
        <source>&amp;Tune Decimation</source>
        <translation>간략화 조정(&amp;T)</translation>
    </message>
    <message>
        <source>Show the decimation parameters</source>
        <translation>간략화 파라미터를 표시합니다</translation>
    </message>
    <message>
        <source>&amp;Default Parameters</source>
        <translation>기본 파라미터(&amp;D)</translation>
    </message>
    <message>
        <source>Reset all decimation parameters to their defaults</source>
        <translation>간략화 파라미터를 모두 기본값으로 되돌립니다</translation>
    </message>
    <message>
        <source>&amp;Export Mesh…</source>
        <translation>메시 내보내기(&amp;E)…</translation>
    </message>
    <message>
        <source>Export &amp;Full-Resolution Mesh…</source>
        <translation>전체 해상도 메시 내보내기(&amp;F)…</translation>
    </message>
</context>
<context>
    <name>NumberBox</name>
    <message>
        <source>%1 is out of range: %2 to %3%4.</source>
        <translation>%1은(는) 범위를 벗어납니다: %2~%3%4.</translation>
    </message>
</context>
<context>
    <name>OutsideQuestion</name>
    <message>
        <source>%1 uses files outside its folder:</source>
        <translation>%1이(가) 폴더 밖의 파일을 사용합니다:</translation>
    </message>
    <message>
        <source>Files outside the folder of the job</source>
        <translation>작업 폴더 밖의 파일</translation>
    </message>
    <message>
        <source>Allow this only if you trust the job. Your answer is remembered for this job and these files.</source>
        <translation>이 작업을 신뢰하는 경우에만 허용하십시오. 응답은 이 작업과 이 파일에 대해 기억됩니다.</translation>
    </message>
    <message>
        <source>&amp;Allow and Open</source>
        <translation>허용하고 열기(&amp;A)</translation>
    </message>
</context>
<context>
    <name>ParameterForm</name>
    <message>
        <source>on</source>
        <translation>켬</translation>
    </message>
    <message>
        <source>off</source>
        <translation>끔</translation>
    </message>
    <message>
        <source>Back to the default: %1</source>
        <translation>기본값으로 되돌리기: %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>%1 초기화</translation>
    </message>
</context>
<context>
    <name>PartForm</name>
    <message>
        <source>Design Part</source>
        <translation>설계 형상</translation>
    </message>
    <message>
        <source>Mesh (%1)</source>
        <translation>메시 (%1)</translation>
    </message>
    <message>
        <source>No design part</source>
        <translation>설계 형상 없음</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>선택…</translation>
    </message>
    <message>
        <source>Choose the part that the stock is compared with (STL)</source>
        <translation>소재와 비교할 설계 형상 선택(STL)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>제거</translation>
    </message>
    <message>
        <source>Compare the stock with no part</source>
        <translation>소재를 비교하지 않음</translation>
    </message>
</context>
<context>
    <name>PartPanel</name>
    <message>
        <source>Open a program, then choose the part that it makes.</source>
        <translation>프로그램을 연 다음 만들 설계 형상을 선택하십시오.</translation>
    </message>
    <message>
        <source>Choose the part that the program makes: the stock is then compared with it.</source>
        <translation>프로그램이 만드는 설계 형상을 선택하면 소재와 비교합니다.</translation>
    </message>
    <message>
        <source>Reading the part…</source>
        <translation>설계 형상을 읽는 중…</translation>
    </message>
    <message>
        <source>There is not enough memory for the part.</source>
        <translation>설계 형상을 읽을 메모리가 부족합니다.</translation>
    </message>
    <message>
        <source>Checking the program and comparing the stock…</source>
        <translation>프로그램을 검사하고 소재를 비교하는 중…</translation>
    </message>
    <message>
        <source>The program is not checked.</source>
        <translation>프로그램을 검사하지 않습니다.</translation>
    </message>
    <message>
        <source>The stock is not compared with the part: see the problems.</source>
        <translation>소재를 설계 형상과 비교하지 않습니다. 문제를 보십시오.</translation>
    </message>
    <message>
        <source>Nothing is out of tolerance.</source>
        <translation>공차를 벗어난 곳이 없습니다.</translation>
    </message>
    <message>
        <source>Save Islands</source>
        <translation>편차 영역 저장</translation>
    </message>
    <message>
        <source>Table (%1)</source>
        <translation>표 (%1)</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>CSV 저장…</translation>
    </message>
    <message>
        <source>Save the islands as a table</source>
        <translation>편차 영역을 표로 저장</translation>
    </message>
    <message>
        <source>Places out of tolerance</source>
        <translation>공차를 벗어난 곳</translation>
    </message>
</context>
<context>
    <name>PartText</name>
    <message>
        <source>Gouge</source>
        <translation>과절삭</translation>
    </message>
    <message>
        <source>Excess</source>
        <translation>미절삭</translation>
    </message>
    <message>
        <source>reached by no tool</source>
        <translation>공구가 닿지 않음</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>확인 안 됨</translation>
    </message>
    <message>
        <source>%1, %2 mm deep, %3 mm², %4 mm³, at X%5 Y%6 Z%7</source>
        <translation>%1, 깊이 %2 mm, %3 mm², %4 mm³, X%5 Y%6 Z%7</translation>
    </message>
    <message>
        <source>Line %1, T%2</source>
        <translation>%1행, T%2</translation>
    </message>
    <message>
        <source>allowed: −%1 to +%2 mm</source>
        <translation>허용: −%1~+%2 mm</translation>
    </message>
    <message>
        <source>Gouges: %1, up to %2 mm deep, %3 mm³</source>
        <translation>과절삭: %1, 최대 깊이 %2 mm, %3 mm³</translation>
    </message>
    <message>
        <source>Excesses: %1, up to %2 mm high, %3 mm³</source>
        <translation>미절삭: %1, 최대 높이 %2 mm, %3 mm³</translation>
    </message>
    <message>
        <source>In tolerance: deviations from %1 to %2 mm</source>
        <translation>공차 안: 편차 %1~%2 mm</translation>
    </message>
    <message>
        <source>not all of it can be judged</source>
        <translation>일부는 판정할 수 없음</translation>
    </message>
</context>
<context>
    <name>PartView</name>
    <message>
        <source>The part is being read.</source>
        <translation>설계 형상을 읽는 중입니다.</translation>
    </message>
    <message>
        <source>The part cannot be used; see Problems.</source>
        <translation>설계 형상을 사용할 수 없습니다. 문제 패널을 확인하십시오.</translation>
    </message>
    <message>
        <source>Not enough graphics memory for these colours.</source>
        <translation>그래픽 메모리가 부족하여 이 색을 표시할 수 없습니다.</translation>
    </message>
    <message>
        <source>Comparing: %1 %</source>
        <translation>비교 중: %1 %</translation>
    </message>
    <message>
        <source>The stock cannot be compared.</source>
        <translation>소재를 비교할 수 없습니다.</translation>
    </message>
    <message>
        <source>New cuts are compared when playback stops.</source>
        <translation>새 절삭은 재생이 멈추면 비교됩니다.</translation>
    </message>
</context>
<context>
    <name>PlotView</name>
    <message>
        <source>Not measured.</source>
        <translation>측정되지 않았습니다.</translation>
    </message>
    <message>
        <source>Play, or press %1.</source>
        <translation>재생하거나 %1 키를 누르십시오.</translation>
    </message>
    <message>
        <source>Play to measure</source>
        <translation>재생하면 측정됩니다</translation>
    </message>
    <message>
        <source>Parameters changed here</source>
        <translation>여기서 파라미터가 바뀌었습니다</translation>
    </message>
    <message>
        <source>%1 (log)</source>
        <translation>%1(로그)</translation>
    </message>
    <message>
        <source>Not drawn yet</source>
        <translation>아직 그리지 않음</translation>
    </message>
    <message>
        <source>Upload and drawing: mean of blocks %1 to %2 (one frame)</source>
        <translation>전송과 그리기: 블록 %1~%2의 평균(한 화면)</translation>
    </message>
</context>
<context>
    <name>Plots</name>
    <message>
        <source>Without decimation</source>
        <translation>간략화 안 함</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>표시됨</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>절삭</translation>
    </message>
    <message>
        <source>Decimation</source>
        <translation>간략화</translation>
    </message>
    <message>
        <source>Upload</source>
        <translation>전송</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>그리기</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>제거됨</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>블록</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>삼각형</translation>
    </message>
    <message>
        <source>Removed Volume</source>
        <translation>제거 체적</translation>
    </message>
    <message>
        <source>Volume (mm³)</source>
        <translation>체적(mm³)</translation>
    </message>
    <message>
        <source>Time per Block</source>
        <translation>블록당 시간</translation>
    </message>
    <message>
        <source>Time (ms)</source>
        <translation>시간(ms)</translation>
    </message>
    <message>
        <source>Axial depth</source>
        <translation>축방향 깊이</translation>
    </message>
    <message>
        <source>Radial engagement</source>
        <translation>반경방향 물림</translation>
    </message>
    <message>
        <source>Axial Depth</source>
        <translation>축방향 깊이</translation>
    </message>
    <message>
        <source>Depth ap (mm)</source>
        <translation>깊이 ap (mm)</translation>
    </message>
    <message>
        <source>Radial Engagement</source>
        <translation>반경방향 물림</translation>
    </message>
    <message>
        <source>Width ae (mm)</source>
        <translation>폭 ae (mm)</translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation>절삭률</translation>
    </message>
    <message>
        <source>Volume per length</source>
        <translation>길이당 체적</translation>
    </message>
    <message>
        <source>Removal Rate</source>
        <translation>절삭률</translation>
    </message>
    <message>
        <source>MRR (mm³/min)</source>
        <translation>MRR (mm³/min)</translation>
    </message>
    <message>
        <source>Volume per Length</source>
        <translation>길이당 체적</translation>
    </message>
    <message>
        <source>Volume (mm³/mm)</source>
        <translation>체적 (mm³/mm)</translation>
    </message>
</context>
<context>
    <name>PlotsPanel</name>
    <message>
        <source>Plots</source>
        <translation>그래프</translation>
    </message>
    <message>
        <source>Show or hide the plot &quot;%1&quot;</source>
        <translation>&quot;%1&quot; 그래프를 표시하거나 숨깁니다</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>따라가기</translation>
    </message>
    <message>
        <source>Keep the current block in view; dragging a plot turns this off</source>
        <translation>현재 블록이 보이도록 유지합니다. 그래프를 끌면 꺼집니다</translation>
    </message>
    <message>
        <source>Export Plot</source>
        <translation>그래프 내보내기</translation>
    </message>
    <message>
        <source>Export as &amp;CSV…</source>
        <translation>CSV로 내보내기(&amp;C)…</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Export as &amp;PNG…</source>
        <translation>PNG로 내보내기(&amp;P)…</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>Export as &amp;SVG…</source>
        <translation>SVG로 내보내기(&amp;S)…</translation>
    </message>
    <message>
        <source>SVG (*.svg)</source>
        <translation>SVG (*.svg)</translation>
    </message>
    <message>
        <source>C&amp;opy Data as CSV</source>
        <translation>데이터를 CSV로 복사(&amp;O)</translation>
    </message>
    <message>
        <source>Show &amp;All Blocks</source>
        <translation>모든 블록 표시(&amp;A)</translation>
    </message>
</context>
<context>
    <name>ProblemCommands</name>
    <message>
        <source>&amp;Next Problem</source>
        <translation>다음 문제(&amp;N)</translation>
    </message>
    <message>
        <source>Go to the line of the next problem</source>
        <translation>다음 문제가 있는 줄로 이동합니다</translation>
    </message>
    <message>
        <source>&amp;Previous Problem</source>
        <translation>이전 문제(&amp;P)</translation>
    </message>
    <message>
        <source>Go to the line of the previous problem</source>
        <translation>이전 문제가 있는 줄로 이동합니다</translation>
    </message>
    <message>
        <source>&amp;Rules…</source>
        <translation>규칙(&amp;R)…</translation>
    </message>
    <message>
        <source>Choose the rules of the check, and their limits</source>
        <translation>검사 규칙과 한계값을 고릅니다</translation>
    </message>
</context>
<context>
    <name>ProblemsModel</name>
    <message>
        <source>Severity</source>
        <translation>심각도</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>줄</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>문제</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>조치</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>식별자</translation>
    </message>
    <message>
        <source>Results after this are unverified.</source>
        <translation>이후의 결과는 검증되지 않습니다.</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>승인됨</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>검사 안 됨</translation>
    </message>
    <message>
        <source>Check it yourself; then accept it in the context menu.</source>
        <translation>직접 확인한 다음 바로 가기 메뉴에서 승인하십시오.</translation>
    </message>
    <message>
        <source>Lines %1 to %2, %3 times.</source>
        <translation>%1~%2줄, %3회.</translation>
    </message>
    <message>
        <source>Largest value: %1; limit: %2 %3.</source>
        <translation>최댓값: %1, 한계: %2 %3.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>공구</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>크기</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>횟수</translation>
    </message>
    <message>
        <source>Waived by %1: %2</source>
        <translation>%1이(가) 예외 처리함: %2</translation>
    </message>
    <message>
        <source>Waived</source>
        <translation>예외 처리됨</translation>
    </message>
    <message>
        <source>Of the check before the last change</source>
        <translation>마지막 변경 전의 검사 결과</translation>
    </message>
</context>
<context>
    <name>ProblemsPanel</name>
    <message>
        <source>Waived</source>
        <translation>예외 처리됨</translation>
    </message>
    <message>
        <source>Remove the Waiver</source>
        <translation>예외 제거</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>문제</translation>
    </message>
    <message>
        <source>No problems found.</source>
        <translation>문제가 없습니다.</translation>
    </message>
    <message>
        <source>Go to Line</source>
        <translation>줄로 이동</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>복사</translation>
    </message>
    <message>
        <source>Ignore M%1: It Moves No Axis</source>
        <translation>M%1 무시: 축을 움직이지 않음</translation>
    </message>
    <message>
        <source>Open a program to see its problems.</source>
        <translation>프로그램을 열면 문제가 표시됩니다.</translation>
    </message>
    <message>
        <source>Reading the program; no problems so far.</source>
        <translation>프로그램을 읽는 중입니다. 아직 문제가 없습니다.</translation>
    </message>
    <message>
        <source>Not simulated yet; no problems in the program text.</source>
        <translation>아직 시뮬레이션하지 않았습니다. 프로그램 텍스트에는 문제가 없습니다.</translation>
    </message>
    <message>
        <source>No problems up to block %1 of %2.</source>
        <translation>블록 %2개 중 %1까지 문제가 없습니다.</translation>
    </message>
    <message>
        <source>Ignore All Unknown M Codes of This Program</source>
        <translation>이 프로그램의 알 수 없는 M 코드 모두 무시</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>검사 안 됨</translation>
    </message>
    <message>
        <source>Checking the program; no problems so far.</source>
        <translation>프로그램을 검사하는 중입니다. 지금까지 문제가 없습니다.</translation>
    </message>
    <message>
        <source>Accept Without a Check, for All Programs</source>
        <translation>검사 없이 승인(모든 프로그램)</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>필터</translation>
    </message>
    <message>
        <source>Filter the problems</source>
        <translation>문제 필터링</translation>
    </message>
    <message>
        <source>Show only the rows that contain this text</source>
        <translation>이 텍스트가 들어 있는 행만 표시합니다</translation>
    </message>
    <message>
        <source>since the last check: %1 new, %2 gone</source>
        <translation>지난 검사 이후: 새로 %1, 해결 %2</translation>
    </message>
    <message>
        <source>Withdraw the Waiver</source>
        <translation>예외 취소</translation>
    </message>
    <message>
        <source>Waive…</source>
        <translation>예외 처리…</translation>
    </message>
    <message>
        <source>Turn This Rule Off in the Job</source>
        <translation>이 작업에서 이 규칙 끄기</translation>
    </message>
    <message>
        <source>Turn It Off for T%1</source>
        <translation>T%1에서만 끄기</translation>
    </message>
    <message>
        <source>New: %1</source>
        <translation>새로: %1</translation>
    </message>
    <message>
        <source>Gone: %1</source>
        <translation>해결: %1</translation>
    </message>
    <message>
        <source>No problems found (%1).</source>
        <translation>문제가 없습니다(%1).</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>검사 중…</translation>
    </message>
</context>
<context>
    <name>RecentMenu</name>
    <message>
        <source>Clear List</source>
        <translation>목록 지우기</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1(없음)</translation>
    </message>
    <message>
        <source>File not found.</source>
        <translation>파일을 찾을 수 없습니다.</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>untitled</source>
        <translation>제목 없음</translation>
    </message>
    <message>
        <source>in the backup</source>
        <translation>백업에</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>셋업</translation>
    </message>
    <message>
        <source>Discard unsaved changes</source>
        <translation>저장하지 않은 변경 버리기</translation>
    </message>
    <message>
        <source>Discard the unsaved changes of %1?</source>
        <translation>%1의 저장하지 않은 변경을 버릴까요?</translation>
    </message>
    <message>
        <source>The backup will be deleted. The file on disk is not changed.</source>
        <translation>백업이 삭제됩니다. 디스크의 파일은 변경되지 않습니다.</translation>
    </message>
</context>
<context>
    <name>RecoveryBar</name>
    <message>
        <source>Proveout did not close normally. These unsaved changes can be restored:</source>
        <translation>Proveout이 정상적으로 종료되지 않았습니다. 저장하지 않은 다음 변경을 복원할 수 있습니다:</translation>
    </message>
    <message>
        <source>program and setup</source>
        <translation>프로그램과 셋업</translation>
    </message>
    <message>
        <source>program</source>
        <translation>프로그램</translation>
    </message>
    <message>
        <source>setup</source>
        <translation>셋업</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>제목 없음</translation>
    </message>
    <message>
        <source>%1 (%2), %3</source>
        <translation>%1(%2), %3</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>복원</translation>
    </message>
    <message>
        <source>Open the backup as unsaved changes; the file is not changed</source>
        <translation>백업을 저장하지 않은 변경으로 엽니다. 파일은 변경되지 않습니다</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>비교…</translation>
    </message>
    <message>
        <source>Show the differences between the backup and the file</source>
        <translation>백업과 파일의 차이를 표시합니다</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>버리기</translation>
    </message>
    <message>
        <source>Delete the backup; the file is not changed</source>
        <translation>백업을 삭제합니다. 파일은 변경되지 않습니다</translation>
    </message>
</context>
<context>
    <name>RulesDialog</name>
    <message>
        <source>Rules of the Check</source>
        <translation>검사 규칙</translation>
    </message>
    <message>
        <source>The job file keeps these settings. How deep, wide and fast a tool may cut is in the tool table; the limits of the machine are in its values.</source>
        <translation>작업 파일이 이 설정을 저장합니다. 공구가 얼마나 깊고 넓고 빠르게 절삭해도 되는지는 공구 테이블에 있고, 기계의 한계는 기계 값에 있습니다.</translation>
    </message>
    <message>
        <source>Other limits for single tools</source>
        <translation>개별 공구의 다른 한계</translation>
    </message>
</context>
<context>
    <name>RunToEnd</name>
    <message>
        <source>stock after block %1 of %2</source>
        <translation>소재(블록 %1/%2 이후)</translation>
    </message>
    <message>
        <source>Program not run to the end</source>
        <translation>프로그램이 끝까지 실행되지 않음</translation>
    </message>
    <message>
        <source>The simulation is at block %1 of %2.</source>
        <translation>시뮬레이션이 블록 %1/%2에 있습니다.</translation>
    </message>
    <message>
        <source>Use the stock as it is now, or run the program to the end first?</source>
        <translation>소재를 지금 상태로 사용할까요, 아니면 먼저 프로그램을 끝까지 실행할까요?</translation>
    </message>
    <message>
        <source>&amp;Run to the End First</source>
        <translation>먼저 끝까지 실행(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Use Stock as Is</source>
        <translation>지금 상태 사용(&amp;U)</translation>
    </message>
    <message>
        <source>Run to the End</source>
        <translation>끝까지 실행</translation>
    </message>
    <message>
        <source>Running the program to the end…</source>
        <translation>프로그램을 끝까지 실행하는 중…</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>Core insert</source>
        <translation>코어 인서트</translation>
    </message>
    <message>
        <source>Mouse case</source>
        <translation>마우스 케이스</translation>
    </message>
</context>
<context>
    <name>SaveQuestion</name>
    <message>
        <source>File changed on disk</source>
        <translation>디스크의 파일이 변경됨</translation>
    </message>
    <message>
        <source>%1 has changed on disk.</source>
        <translation>디스크에서 %1이(가) 변경되었습니다.</translation>
    </message>
    <message>
        <source>Another program or window wrote it at %1. Saving here would overwrite those changes.

Keep Both saves your version as a new file in the same folder.</source>
        <translation>%1에 다른 프로그램이나 창이 이 파일을 저장했습니다. 여기서 저장하면 그 변경을 덮어씁니다.

‘둘 다 유지’를 선택하면 현재 버전을 같은 폴더에 새 파일로 저장합니다.</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>덮어쓰기(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Keep Both</source>
        <translation>둘 다 유지(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>비교(&amp;C)…</translation>
    </message>
    <message>
        <source>Stock in use</source>
        <translation>사용 중인 소재</translation>
    </message>
    <message>
        <source>%1 is the stock of the open job.</source>
        <translation>%1은(는) 열려 있는 작업의 소재입니다.</translation>
    </message>
    <message>
        <source>If you overwrite it, the job will start from its own result the next time it is opened.</source>
        <translation>덮어쓰면 다음에 작업을 열 때 자신의 결과에서 시작합니다.</translation>
    </message>
</context>
<context>
    <name>SetupPanel</name>
    <message>
        <source>%1 × %2 points, spacing %3 × %4 mm; needs about %5, at most %6</source>
        <translation>%1 × %2점, 간격 %3 × %4 mm, 약 %5, 최대 %6 필요</translation>
    </message>
    <message>
        <source>Stock and grid</source>
        <translation>소재와 격자</translation>
    </message>
    <message>
        <source>Fit to program</source>
        <translation>프로그램에 맞춤</translation>
    </message>
    <message>
        <source>Fit the stock to the toolpath</source>
        <translation>소재를 공구 경로에 맞춥니다</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>공구</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>제어기</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 읽는 중…</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>기계</translation>
    </message>
    <message>
        <source>Tools missing from the table: %1</source>
        <translation>테이블에 없는 공구: %1</translation>
    </message>
    <message>
        <source>Add missing tools (⌀ 10 mm assumed)</source>
        <translation>없는 공구 추가(⌀ 10 mm로 가정)</translation>
    </message>
    <message>
        <source>Add these tools; then enter the sizes of your cutters</source>
        <translation>이 공구들을 추가합니다. 그다음 실제 공구의 치수를 입력하십시오</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>고정구</translation>
    </message>
</context>
<context>
    <name>Severity</name>
    <message>
        <source>Note</source>
        <translation>참고</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>경고</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>오류</translation>
    </message>
    <message>
        <source>Machining fault</source>
        <translation>가공 결함</translation>
    </message>
</context>
<context>
    <name>SimulateCommands</name>
    <message>
        <source>&amp;Play</source>
        <translation>재생(&amp;P)</translation>
    </message>
    <message>
        <source>Play or pause the program</source>
        <translation>프로그램을 재생하거나 일시 정지합니다</translation>
    </message>
    <message>
        <source>Play from Sta&amp;rt</source>
        <translation>처음부터 재생(&amp;R)</translation>
    </message>
    <message>
        <source>Go to the uncut stock and play</source>
        <translation>가공 전 소재로 돌아가 재생합니다</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>정지(&amp;S)</translation>
    </message>
    <message>
        <source>Stop and go back to the uncut stock</source>
        <translation>정지하고 가공 전 소재로 돌아갑니다</translation>
    </message>
    <message>
        <source>Go to St&amp;art</source>
        <translation>처음으로(&amp;A)</translation>
    </message>
    <message>
        <source>Go to the uncut stock</source>
        <translation>가공 전 소재로 이동합니다</translation>
    </message>
    <message>
        <source>Step &amp;Back</source>
        <translation>한 블록 뒤로(&amp;B)</translation>
    </message>
    <message>
        <source>Go back by one block</source>
        <translation>한 블록 뒤로 갑니다</translation>
    </message>
    <message>
        <source>Step &amp;Forward</source>
        <translation>한 블록 앞으로(&amp;F)</translation>
    </message>
    <message>
        <source>Execute the next block</source>
        <translation>다음 블록을 실행합니다</translation>
    </message>
    <message>
        <source>Go to &amp;End</source>
        <translation>끝으로(&amp;E)</translation>
    </message>
    <message>
        <source>Go to the end of the program</source>
        <translation>프로그램 끝으로 이동합니다</translation>
    </message>
    <message>
        <source>Back by 10 Blocks</source>
        <translation>10블록 뒤로</translation>
    </message>
    <message>
        <source>Go back by 10 blocks</source>
        <translation>10블록 뒤로 갑니다</translation>
    </message>
    <message>
        <source>Forward by 10 Blocks</source>
        <translation>10블록 앞으로</translation>
    </message>
    <message>
        <source>&amp;Measure Whole Program</source>
        <translation>전체 프로그램 측정(&amp;M)</translation>
    </message>
    <message>
        <source>Execute each block that was not played yet, and measure its triangles and times for the plots</source>
        <translation>아직 재생하지 않은 블록을 모두 실행하여 그래프에 쓸 삼각형 수와 시간을 측정합니다</translation>
    </message>
    <message>
        <source>Execute the next 10 blocks</source>
        <translation>다음 10블록을 실행합니다</translation>
    </message>
    <message>
        <source>Previous &amp;Tool Change</source>
        <translation>이전 공구 교환(&amp;T)</translation>
    </message>
    <message>
        <source>Go back to the previous tool change</source>
        <translation>이전 공구 교환으로 돌아갑니다</translation>
    </message>
    <message>
        <source>Next T&amp;ool Change</source>
        <translation>다음 공구 교환(&amp;O)</translation>
    </message>
    <message>
        <source>Go to the next tool change</source>
        <translation>다음 공구 교환으로 이동합니다</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>느리게(&amp;L)</translation>
    </message>
    <message>
        <source>Play slower</source>
        <translation>느리게 재생합니다</translation>
    </message>
    <message>
        <source>Fa&amp;ster</source>
        <translation>빠르게(&amp;S)</translation>
    </message>
    <message>
        <source>Play faster</source>
        <translation>빠르게 재생합니다</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>일시 정지(&amp;P)</translation>
    </message>
    <message>
        <source>Back to Previo&amp;us Position</source>
        <translation>이전 위치로 돌아가기(&amp;U)</translation>
    </message>
    <message>
        <source>Go back to the position before the jump to a cutting block</source>
        <translation>절삭한 블록으로 이동하기 전의 위치로 돌아갑니다</translation>
    </message>
</context>
<context>
    <name>StartForm</name>
    <message>
        <source>Not set: %1 is assumed</source>
        <translation>설정되지 않음: %1(으)로 가정</translation>
    </message>
    <message>
        <source>Not set</source>
        <translation>설정되지 않음</translation>
    </message>
    <message>
        <source>Empty spindle</source>
        <translation>빈 주축</translation>
    </message>
    <message>
        <source>%1, not in the tool table</source>
        <translation>%1, 공구 테이블에 없음</translation>
    </message>
    <message>
        <source>Start position is known</source>
        <translation>시작 위치를 알고 있음</translation>
    </message>
    <message>
        <source>Start %1</source>
        <comment>an axis</comment>
        <translation>시작 %1</translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>%1 (missing)</source>
        <translation>%1(없음)</translation>
    </message>
    <message>
        <source>See what an NC program cuts before the machine does.</source>
        <translation>기계보다 먼저 NC 프로그램의 절삭 결과를 확인하십시오.</translation>
    </message>
    <message>
        <source>Open File…</source>
        <translation>파일 열기…</translation>
    </message>
    <message>
        <source>Open an NC program or a job</source>
        <translation>NC 프로그램이나 작업을 엽니다</translation>
    </message>
    <message>
        <source>New Program</source>
        <translation>새 프로그램</translation>
    </message>
    <message>
        <source>Create an empty NC program</source>
        <translation>빈 NC 프로그램을 만듭니다</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>예제</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>최근 파일</translation>
    </message>
    <message>
        <source>Or drop a file anywhere on this window.</source>
        <translation>또는 이 창의 아무 곳에나 파일을 끌어다 놓으십시오.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>언어</translation>
    </message>
    <message>
        <source>Language of the user interface</source>
        <translation>사용자 인터페이스 언어</translation>
    </message>
    <message>
        <source>%1
File not found.</source>
        <translation>%1
파일을 찾을 수 없습니다.</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>%1(으)로 돌아가기</translation>
    </message>
    <message>
        <source>Go back to the open document (Esc)</source>
        <translation>열려 있는 문서로 돌아갑니다 (Esc)</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>%1 · %2 left</source>
        <translation>%1 · %2 남음</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Cancel this task</source>
        <translation>진행 중인 동작을 취소합니다</translation>
    </message>
    <message>
        <source>Feed rate, mm/min</source>
        <translation>이송 속도, mm/min</translation>
    </message>
    <message>
        <source>Spindle speed, rpm</source>
        <translation>주축 회전수, rpm</translation>
    </message>
    <message>
        <source>Tool in the spindle</source>
        <translation>주축의 공구</translation>
    </message>
    <message>
        <source>Motion blocks executed / total</source>
        <translation>실행한 이동 블록 / 전체</translation>
    </message>
    <message>
        <source>Triangles shown</source>
        <translation>표시된 삼각형</translation>
    </message>
    <message>
        <source>Block %1 / %2</source>
        <translation>블록 %1 / %2</translation>
    </message>
    <message>
        <source>Triangles %1</source>
        <translation>삼각형 %1</translation>
    </message>
    <message>
        <source>F rapid</source>
        <translation>F 급속</translation>
    </message>
    <message>
        <source>There is no stock at this point.</source>
        <translation>이 위치에는 소재가 없습니다.</translation>
    </message>
    <message>
        <source>Raw stock: not cut up to block %1.</source>
        <translation>원소재: 블록 %1까지 절삭되지 않았습니다.</translation>
    </message>
    <message>
        <source>The program or setup has changed. Try again in a moment.</source>
        <translation>프로그램이나 셋업이 바뀌었습니다. 잠시 후 다시 시도하십시오.</translation>
    </message>
    <message>
        <source>Tool tip X in the active work offset, mm</source>
        <translation>현재 공작물 좌표계의 공구 선단 X, mm</translation>
    </message>
    <message>
        <source>Tool tip Y in the active work offset, mm</source>
        <translation>현재 공작물 좌표계의 공구 선단 Y, mm</translation>
    </message>
    <message>
        <source>Tool tip Z in the active work offset, mm</source>
        <translation>현재 공작물 좌표계의 공구 선단 Z, mm</translation>
    </message>
    <message>
        <source>Cut by block %1: line %2, tool %3.</source>
        <translation>블록 %1에서 절삭: %2번 줄, 공구 %3.</translation>
    </message>
</context>
<context>
    <name>StockChangedBar</name>
    <message>
        <source>%1 has changed on disk. The simulation still uses the version read before.</source>
        <translation>디스크에서 %1이(가) 변경되었습니다. 시뮬레이션은 이전에 읽은 버전을 사용합니다.</translation>
    </message>
    <message>
        <source>%1 was deleted or renamed on disk. The simulation still uses the version read before, but the job cannot be opened without the file.</source>
        <translation>디스크에서 %1이(가) 삭제되었거나 이름이 바뀌었습니다. 시뮬레이션은 이전에 읽은 버전을 사용하지만, 이 파일이 없으면 작업을 열 수 없습니다.</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>다시 읽기(&amp;R)</translation>
    </message>
    <message>
        <source>Read the stock again and simulate with it</source>
        <translation>소재를 다시 읽어 시뮬레이션합니다</translation>
    </message>
    <message>
        <source>&amp;Keep This Version</source>
        <translation>이 버전 유지(&amp;K)</translation>
    </message>
    <message>
        <source>Continue with the stock read before</source>
        <translation>이전에 읽은 소재로 계속합니다</translation>
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
범위: %2~%3 mm
기본값: %4 mm</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>모든 파일 (*)</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>형상</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>파일 선택</translation>
    </message>
</context>
<context>
    <name>StudyPanel</name>
    <message>
        <source>Measured, chosen</source>
        <translation>측정값, 선택됨</translation>
    </message>
    <message>
        <source>Measured, current</source>
        <translation>측정값, 현재</translation>
    </message>
    <message>
        <source>Rendering time</source>
        <translation>렌더링 시간</translation>
    </message>
    <message>
        <source>Fig. %1</source>
        <translation>그림 %1</translation>
    </message>
    <message>
        <source>This sweep does not apply to the current decimation method.</source>
        <translation>현재 간략화 방법에는 이 스윕을 적용할 수 없습니다.</translation>
    </message>
    <message>
        <source>Region size %1, period %2: predicted %3 s, without decimation %4 s</source>
        <translation>영역 크기 %1, 주기 %2: 예측 %3 s, 간략화 없이 %4 s</translation>
    </message>
    <message>
        <source>measured %1 s, with the current parameters %2 s</source>
        <translation>측정 %1 s, 현재 파라미터로 %2 s</translation>
    </message>
    <message>
        <source>Export Figure</source>
        <translation>그림 내보내기</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>연구</translation>
    </message>
    <message>
        <source>What the sweep varies</source>
        <translation>스윕에서 변화시키는 값</translation>
    </message>
    <message>
        <source>Run a sweep to see its figures here.</source>
        <translation>스윕을 실행하면 그림이 여기에 표시됩니다.</translation>
    </message>
    <message>
        <source>Figure of the paper to draw</source>
        <translation>그릴 논문의 그림</translation>
    </message>
    <message>
        <source>&amp;Run Sweep</source>
        <translation>스윕 실행(&amp;R)</translation>
    </message>
    <message>
        <source>Run the program once for each point of the paper&apos;s curves</source>
        <translation>논문 곡선의 각 점마다 프로그램을 한 번씩 실행합니다</translation>
    </message>
    <message>
        <source>&amp;Optimise</source>
        <translation>최적화(&amp;O)</translation>
    </message>
    <message>
        <source>Choose region size and period from a short trial run, then measure them</source>
        <translation>짧은 시험 실행으로 영역 크기와 주기를 고른 다음 측정합니다</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>적용(&amp;U)</translation>
    </message>
    <message>
        <source>Use the chosen region size and period</source>
        <translation>선택된 영역 크기와 주기를 적용합니다</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>취소(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>내보내기(&amp;E)…</translation>
    </message>
    <message>
        <source>Figures (%1)</source>
        <translation>그림(%1)</translation>
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
        <translation>원소재</translation>
    </message>
    <message>
        <source>Line %1, %2</source>
        <translation>%1번 줄, %2</translation>
    </message>
    <message>
        <source>Deviation %1 mm (excess)</source>
        <translation>편차 %1 mm (미절삭)</translation>
    </message>
    <message>
        <source>Deviation %1 mm (gouge)</source>
        <translation>편차 %1 mm (과절삭)</translation>
    </message>
    <message>
        <source>Deviation %1 mm</source>
        <translation>편차 %1 mm</translation>
    </message>
</context>
<context>
    <name>TimelinePanel</name>
    <message>
        <source>Timeline</source>
        <translation>타임라인</translation>
    </message>
    <message>
        <source>Drag to go to any block; wheel or arrow keys: one block, with Shift: more</source>
        <translation>끌어서 원하는 블록으로 이동합니다. 휠 또는 화살표 키: 한 블록, Shift와 함께: 여러 블록</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속도</translation>
    </message>
    <message>
        <source>Playback speed; 1× is %1 blocks per second</source>
        <translation>재생 속도입니다. 1×는 초당 %1블록입니다</translation>
    </message>
    <message>
        <source>Motion blocks executed / total</source>
        <translation>실행한 이동 블록 / 전체</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>가능한 한 빠르게</translation>
    </message>
    <message>
        <source>Every block (paper mode)</source>
        <translation>모든 블록(논문 모드)</translation>
    </message>
    <message>
        <source>Each block is drawn before the next one is cut</source>
        <translation>다음 블록을 절삭하기 전에 각 블록을 그립니다</translation>
    </message>
    <message>
        <source>There is a problem on this line.</source>
        <translation>이 줄에 문제가 있습니다.</translation>
    </message>
    <message>
        <source>%1× (%2 blocks/s)</source>
        <translation>%1× (%2블록/s)</translation>
    </message>
    <message>
        <source>Play by</source>
        <translation>재생 기준</translation>
    </message>
    <message>
        <source>Pace of playback: by block, by path length or by machine time</source>
        <translation>재생 기준: 블록, 경로 길이 또는 기계 시간</translation>
    </message>
    <message>
        <source>Cutting takes longer than this speed allows: playback is slower, but the stock is always correct</source>
        <translation>절삭 계산이 재생 속도를 따라가지 못해 더 느리게 재생합니다. 소재는 언제나 정확합니다</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>블록</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>경로 길이</translation>
    </message>
    <message>
        <source>Machine time</source>
        <translation>기계 시간</translation>
    </message>
    <message>
        <source>%1× (%2 mm/s)</source>
        <translation>%1×(%2 mm/s)</translation>
    </message>
    <message>
        <source>%1× machine</source>
        <translation>기계의 %1×</translation>
    </message>
    <message>
        <source>Playback speed; 1× is %1 mm of path per second</source>
        <translation>재생 속도. 1×는 초당 경로 %1 mm입니다</translation>
    </message>
    <message>
        <source>Playback speed; 1× is the speed of the machine</source>
        <translation>재생 속도. 1×는 기계의 속도입니다</translation>
    </message>
    <message>
        <source>Actual speed %1×</source>
        <translation>실제 속도 %1×</translation>
    </message>
    <message>
        <source>Block %1 · line %2 · %3</source>
        <translation>블록 %1 · 줄 %2 · %3</translation>
    </message>
</context>
<context>
    <name>ToolDrawing</name>
    <message>
        <source>Drawing of the tool</source>
        <translation>공구 그림</translation>
    </message>
    <message>
        <source>The tool to scale: cutting part, shank, holder</source>
        <translation>비율에 맞춘 공구: 절삭부, 섕크, 홀더</translation>
    </message>
</context>
<context>
    <name>ToolForm</name>
    <message>
        <source>Shape</source>
        <translation>형상</translation>
    </message>
    <message>
        <source>Cutter shape</source>
        <translation>커터 형상</translation>
    </message>
    <message>
        <source>%1
Range: %2 to %3 %4
Default: %5 %4</source>
        <translation>%1
범위: %2~%3 %4
기본값: %5 %4</translation>
    </message>
    <message>
        <source>For an arc, add the centre or the radius to its end point, as in %1 or %2; a negative radius is concave.
Default: %3</source>
        <translation>원호는 %1 또는 %2처럼 끝점에 중심이나 반경을 덧붙입니다. 음수 반경은 오목한 원호입니다.
기본값: %3</translation>
    </message>
    <message>
        <source>Example: %1</source>
        <translation>예: %1</translation>
    </message>
</context>
<context>
    <name>ToolLimitsEditor</name>
    <message>
        <source>Tool</source>
        <translation>공구</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>규칙</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>한계</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>추가</translation>
    </message>
    <message>
        <source>Remove this limit</source>
        <translation>이 한계 제거</translation>
    </message>
</context>
<context>
    <name>ToolNotice</name>
    <message>
        <source>Hide this notice</source>
        <translation>이 알림 숨기기</translation>
    </message>
    <message>
        <source>The program cuts before it calls a tool; those moves are not simulated.</source>
        <translation>공구를 호출하기 전에 절삭합니다. 그 이동은 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>T%1 is not in the tool table; its moves are not simulated.</source>
        <translation>T%1이(가) 공구 테이블에 없어 그 이동을 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>%1 are not in the tool table; their moves are not simulated.</source>
        <translation>%1이(가) 공구 테이블에 없어 그 이동을 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>Nothing is cut.</source>
        <translation>아무것도 절삭하지 않습니다.</translation>
    </message>
    <message>
        <source>Define T%1…</source>
        <translation>T%1 정의…</translation>
    </message>
    <message>
        <source>Add T%1 to the tool table and enter its sizes</source>
        <translation>공구 테이블에 T%1을(를) 추가하고 치수를 입력합니다</translation>
    </message>
    <message>
        <source>Assume ⌀ 10 mm</source>
        <translation>⌀ 10 mm로 가정</translation>
    </message>
    <message>
        <source>Add the missing tools as 10 mm flat end mills, marked as assumed</source>
        <translation>없는 공구를 10 mm 평 엔드밀로 추가하고 가정한 값으로 표시합니다</translation>
    </message>
    <message>
        <source>The sizes of %1 are not confirmed.</source>
        <translation>%1의 치수가 확인되지 않았습니다.</translation>
    </message>
    <message>
        <source>T%1 was read from the comment in line %2: %3.</source>
        <translation>T%1은(는) %2번 줄의 주석에서 읽었습니다: %3.</translation>
    </message>
    <message>
        <source>The sizes of T%1 are assumed: %2.</source>
        <translation>T%1의 치수는 가정한 값입니다: %2.</translation>
    </message>
    <message>
        <source>Check…</source>
        <translation>점검…</translation>
    </message>
    <message>
        <source>Show T%1 in the tool table</source>
        <translation>공구 테이블에서 T%1을(를) 표시합니다</translation>
    </message>
    <message>
        <source>Confirm All</source>
        <translation>모두 확인</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>확인</translation>
    </message>
    <message>
        <source>Confirm the sizes in the tool table</source>
        <translation>공구 테이블의 치수를 확인합니다</translation>
    </message>
    <message>
        <source>The program calls no tool; its moves are not simulated.</source>
        <translation>프로그램이 공구를 호출하지 않습니다. 이동을 시뮬레이션하지 않습니다.</translation>
    </message>
    <message>
        <source>Results are unverified until you confirm the sizes.</source>
        <translation>치수를 확인할 때까지 결과는 검증되지 않습니다.</translation>
    </message>
</context>
<context>
    <name>ToolTableEditor</name>
    <message>
        <source>T%1 is already in the table.</source>
        <translation>T%1은(는) 이미 테이블에 있습니다.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>공구</translation>
    </message>
    <message>
        <source>Cutter</source>
        <translation>커터</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>공구</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>추가</translation>
    </message>
    <message>
        <source>Add a tool with the next free number</source>
        <translation>다음 빈 번호로 공구를 추가합니다</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>제거</translation>
    </message>
    <message>
        <source>Remove the selected tool</source>
        <translation>선택한 공구를 제거합니다</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>번호</translation>
    </message>
    <message>
        <source>Tool number</source>
        <translation>공구 번호</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>형상</translation>
    </message>
    <message>
        <source>Defined</source>
        <translation>정의됨</translation>
    </message>
    <message>
        <source>Comment, line %1</source>
        <translation>주석, %1번 줄</translation>
    </message>
    <message>
        <source>Assumed</source>
        <translation>가정함</translation>
    </message>
    <message>
        <source>Default sizes; enter those of your cutter, or confirm them</source>
        <translation>기본 치수입니다. 실제 공구의 치수를 입력하거나 이 값을 확인하십시오</translation>
    </message>
    <message>
        <source>These sizes are assumed. Enter those of your cutter, or confirm them.</source>
        <translation>이 치수는 가정한 값입니다. 실제 공구의 치수를 입력하거나 이 값을 확인하십시오.</translation>
    </message>
    <message>
        <source>From the comment in &lt;a href=&quot;%1&quot;&gt;line %1&lt;/a&gt;: &lt;i&gt;%2&lt;/i&gt;</source>
        <translation>&lt;a href=&quot;%1&quot;&gt;%1번 줄&lt;/a&gt;의 주석에서: &lt;i&gt;%2&lt;/i&gt;</translation>
    </message>
    <message>
        <source>Not in the comment, defaults used: %1</source>
        <translation>주석에 없어 기본값 사용: %1</translation>
    </message>
    <message>
        <source>Entered: %1</source>
        <translation>입력함: %1</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>출처</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>확인</translation>
    </message>
    <message>
        <source>Confirm the sizes of the selected tool</source>
        <translation>선택한 공구의 치수를 확인합니다</translation>
    </message>
    <message>
        <source>Confirm All</source>
        <translation>모두 확인</translation>
    </message>
    <message>
        <source>Confirm the sizes of all tools</source>
        <translation>모든 공구의 치수를 확인합니다</translation>
    </message>
    <message>
        <source>The T word that calls this tool (no unit)
Range: %1 to %2
Default: the next free number</source>
        <translation>이 공구를 부르는 T 워드(단위 없음)
범위: %1~%2
기본값: 다음 빈 번호</translation>
    </message>
</context>
<context>
    <name>Tools</name>
    <message>
        <source>%1 (assumed)</source>
        <translation>%1(가정)</translation>
    </message>
    <message>
        <source>no tool</source>
        <translation>공구 없음</translation>
    </message>
</context>
<context>
    <name>TuningPanel</name>
    <message>
        <source>Open a program to see the measured effect.</source>
        <translation>프로그램을 열면 측정된 효과가 표시됩니다.</translation>
    </message>
    <message>
        <source>Triangles shown: %1 of %2 (%3 %)</source>
        <translation>표시된 삼각형: %2개 중 %1개(%3 %)</translation>
    </message>
    <message>
        <source>Regions drawn from the z-map: %1 of %2</source>
        <translation>Z맵으로 그린 영역: %2개 중 %1개</translation>
    </message>
    <message>
        <source>Largest error: %1 mm; the allowance of %2 mm is not guaranteed while Certify is off</source>
        <translation>최대 오차: %1 mm. 오차 보증이 꺼져 있어 허용 오차 %2 mm가 보장되지 않습니다</translation>
    </message>
    <message>
        <source>Measured effect</source>
        <translation>측정된 효과</translation>
    </message>
    <message>
        <source>Largest error: %1 mm anywhere, within the allowance of %2 mm</source>
        <translation>최대 오차: 모든 곳에서 %1 mm, 허용 오차 %2 mm 이내</translation>
    </message>
    <message>
        <source>Largest error: %1 mm at the z-map points, within the allowance of %2 mm</source>
        <translation>최대 오차: Z맵 점에서 %1 mm, 허용 오차 %2 mm 이내</translation>
    </message>
    <message>
        <source>Decimation is off during playback: a frame takes %1 ms without it and %2 ms with it.</source>
        <translation>재생하는 동안 간략화를 끕니다. 한 프레임에 간략화 없이 %1 ms, 간략화하면 %2 ms가 걸립니다.</translation>
    </message>
    <message>
        <source>Decimation is off during playback: there are only %1 triangles to draw without it.</source>
        <translation>재생하는 동안 간략화를 끕니다. 간략화하지 않아도 그릴 삼각형이 %1개뿐입니다.</translation>
    </message>
    <message>
        <source>Largest error: %1 mm anywhere but at walls, within the allowance of %2 mm</source>
        <translation>최대 오차: 벽을 제외한 모든 곳에서 %1 mm, 허용 오차 %2 mm 이내</translation>
    </message>
</context>
<context>
    <name>UndoCommands</name>
    <message>
        <source>Text change</source>
        <translation>텍스트 변경</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>%1 실행 취소(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>%1 다시 실행(&amp;R)</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>The whole program was checked; no faults were found.</source>
        <translation>프로그램 전체를 검사했으며 결함이 없습니다.</translation>
    </message>
    <message>
        <source>Not checked: %1.</source>
        <translation>검사하지 않은 항목: %1.</translation>
    </message>
    <message>
        <source>Accepted without a check: %1.</source>
        <translation>검사 없이 승인된 항목: %1.</translation>
    </message>
    <message>
        <source>Checking… %1 %</source>
        <translation>검사 중… %1 %</translation>
    </message>
    <message>
        <source>SAFE</source>
        <translation>안전</translation>
    </message>
    <message>
        <source>FAULTS %1</source>
        <translation>결함 %1</translation>
    </message>
    <message>
        <source>UNVERIFIED</source>
        <translation>검증되지 않음</translation>
    </message>
    <message>
        <source>Not checked: needs %1</source>
        <translation>검사 안 됨: %1 필요</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>검사 안 됨</translation>
    </message>
    <message>
        <source>The whole program is being checked in the background.</source>
        <translation>프로그램 전체를 백그라운드에서 검사하고 있습니다.</translation>
    </message>
    <message>
        <source>Line %1, block %2: %3</source>
        <translation>%1줄, 블록 %2: %3</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>%1줄: %2</translation>
    </message>
    <message>
        <source>Waived: %1.</source>
        <translation>예외 처리됨: %1.</translation>
    </message>
</context>
<context>
    <name>VerdictBadge</name>
    <message>
        <source>Click to see all findings.</source>
        <translation>클릭하면 모든 검사 결과를 볼 수 있습니다.</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>판정: %1</translation>
    </message>
</context>
<context>
    <name>Viewport</name>
    <message>
        <source>OpenGL is not available on this display; the 3D view is off.</source>
        <translation>이 화면에서는 OpenGL을 쓸 수 없어 3D 보기를 껐습니다.</translation>
    </message>
    <message>
        <source>The OpenGL context could not be created; the 3D view is off.</source>
        <translation>OpenGL 컨텍스트를 만들 수 없어 3D 보기를 껐습니다.</translation>
    </message>
    <message>
        <source>The graphics driver does not support OpenGL 3.3; the 3D view is off.</source>
        <translation>그래픽 드라이버가 OpenGL 3.3을 지원하지 않아 3D 보기를 껐습니다.</translation>
    </message>
    <message>
        <source>%1 of %2 triangles</source>
        <translation>삼각형 %2개 중 %1개</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>급속 이송</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>절삭 이송</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>원호</translation>
    </message>
    <message>
        <source>Drawn from the z-map: %1 regions</source>
        <translation>Z맵으로 그림: 영역 %1개</translation>
    </message>
    <message>
        <source>Decimated: %1 regions</source>
        <translation>간략화됨: 영역 %1개</translation>
    </message>
    <message>
        <source>Region border</source>
        <translation>영역 경계</translation>
    </message>
    <message>
        <source>Triangle edge</source>
        <translation>삼각형 모서리</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D 보기</translation>
    </message>
    <message>
        <source>A shader failed to compile; see the log.</source>
        <translation>셰이더를 컴파일하지 못했습니다. 로그를 확인하십시오.</translation>
    </message>
    <message>
        <source>The picture is being prepared.</source>
        <translation>그림을 준비하고 있습니다.</translation>
    </message>
    <message>
        <source>The picture is coarser than the grid, because the surface has %L1 triangles. Decimation reduces them.</source>
        <translation>표면의 삼각형이 %L1개여서 그림이 격자보다 거칩니다. 단순화하면 줄어듭니다.</translation>
    </message>
    <message>
        <source>The picture is coarser than the grid. Zoom in.</source>
        <translation>그림이 격자보다 거칩니다. 확대하십시오.</translation>
    </message>
    <message>
        <source>The picture is coarser than the grid. Zoom in, or allow more graphics memory.</source>
        <translation>그림이 격자보다 거칩니다. 확대하거나 그래픽 메모리를 더 허용하십시오.</translation>
    </message>
    <message>
        <source>The grid is too large for the graphics driver; the stock is not drawn. Increase the grid spacing.</source>
        <translation>격자가 그래픽 드라이버의 한도를 넘어 소재를 그리지 않습니다. 격자 간격을 넓히십시오.</translation>
    </message>
    <message>
        <source>The detail region is too large for the graphics driver and is not drawn. Increase its grid spacing or make the box smaller.</source>
        <translation>상세 영역이 그래픽 드라이버의 한도를 넘어 그리지 않습니다. 격자 간격을 넓히거나 상자를 줄이십시오.</translation>
    </message>
    <message>
        <source>Click a point on the stock.</source>
        <translation>소재의 한 지점을 클릭하십시오.</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Ctrl+클릭</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>고정구</translation>
    </message>
    <message>
        <source>Design part</source>
        <translation>설계 형상</translation>
    </message>
    <message>
        <source>Deviation from the part, mm</source>
        <translation>설계 형상과의 편차, mm</translation>
    </message>
    <message>
        <source>Deviation from the part with allowance %1, mm</source>
        <translation>여유량 %1을 더한 설계 형상과의 편차, mm</translation>
    </message>
    <message>
        <source>&gt; %1 (excess)</source>
        <translation>&gt; %1 (미절삭)</translation>
    </message>
    <message>
        <source>&lt; %1 (gouge)</source>
        <translation>&lt; %1 (과절삭)</translation>
    </message>
</context>
<context>
    <name>ViewportCommands</name>
    <message>
        <source>&amp;Fit</source>
        <translation>화면 맞춤(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>등각(&amp;I)</translation>
    </message>
    <message>
        <source>View from the right, front and top</source>
        <translation>오른쪽 앞 위에서 봅니다</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>위(&amp;T)</translation>
    </message>
    <message>
        <source>View along -Z</source>
        <translation>-Z 방향으로 봅니다</translation>
    </message>
    <message>
        <source>&amp;Bottom</source>
        <translation>아래(&amp;B)</translation>
    </message>
    <message>
        <source>View along +Z</source>
        <translation>+Z 방향으로 봅니다</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>앞(&amp;R)</translation>
    </message>
    <message>
        <source>View along +Y</source>
        <translation>+Y 방향으로 봅니다</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>뒤(&amp;K)</translation>
    </message>
    <message>
        <source>View along -Y</source>
        <translation>-Y 방향으로 봅니다</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>왼쪽(&amp;L)</translation>
    </message>
    <message>
        <source>View along +X</source>
        <translation>+X 방향으로 봅니다</translation>
    </message>
    <message>
        <source>Ri&amp;ght</source>
        <translation>오른쪽(&amp;G)</translation>
    </message>
    <message>
        <source>View along -X</source>
        <translation>-X 방향으로 봅니다</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>원근(&amp;P)</translation>
    </message>
    <message>
        <source>Perspective or parallel projection</source>
        <translation>원근 또는 평행 투영</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>와이어프레임(&amp;W)</translation>
    </message>
    <message>
        <source>Show the triangles and the borders of the regions</source>
        <translation>삼각형과 영역 경계를 표시합니다</translation>
    </message>
    <message>
        <source>Tint R&amp;egions</source>
        <translation>영역 색 구분(&amp;E)</translation>
    </message>
    <message>
        <source>Colour decimated and undecimated regions differently</source>
        <translation>간략화된 영역과 간략화되지 않은 영역을 다른 색으로 표시합니다</translation>
    </message>
    <message>
        <source>Lege&amp;nd</source>
        <translation>범례(&amp;N)</translation>
    </message>
    <message>
        <source>Show what the colours and lines mean</source>
        <translation>색과 선의 의미를 표시합니다</translation>
    </message>
    <message>
        <source>Hide Toolpat&amp;h</source>
        <translation>공구 경로 숨기기(&amp;H)</translation>
    </message>
    <message>
        <source>Draw no toolpath</source>
        <translation>공구 경로를 그리지 않습니다</translation>
    </message>
    <message>
        <source>Toolp&amp;ath Near the Cutter</source>
        <translation>커터 주변 공구 경로(&amp;A)</translation>
    </message>
    <message>
        <source>Draw the toolpath of the blocks just before and after the current one</source>
        <translation>현재 블록 바로 앞뒤의 공구 경로를 그립니다</translation>
    </message>
    <message>
        <source>Wh&amp;ole Toolpath</source>
        <translation>전체 공구 경로(&amp;O)</translation>
    </message>
    <message>
        <source>Draw the toolpath of the whole program</source>
        <translation>프로그램 전체의 공구 경로를 그립니다</translation>
    </message>
    <message>
        <source>See-Through C&amp;utter</source>
        <translation>반투명 커터(&amp;U)</translation>
    </message>
    <message>
        <source>Make the cutter transparent</source>
        <translation>커터를 투명하게 그립니다</translation>
    </message>
    <message>
        <source>Hi&amp;de Cutter</source>
        <translation>커터 숨기기(&amp;D)</translation>
    </message>
    <message>
        <source>Draw no cutter</source>
        <translation>커터를 그리지 않습니다</translation>
    </message>
    <message>
        <source>&amp;Magnifier</source>
        <translation>돋보기(&amp;M)</translation>
    </message>
    <message>
        <source>Cut a box of the stock again on a much finer grid</source>
        <translation>소재의 한 부분을 훨씬 촘촘한 격자로 다시 절삭합니다</translation>
    </message>
    <message>
        <source>Go to &amp;Cutting Block</source>
        <translation>절삭한 블록으로 이동(&amp;C)</translation>
    </message>
    <message>
        <source>Click a point on the stock to go to the block that cut it</source>
        <translation>소재의 한 지점을 클릭하면 그곳을 절삭한 블록으로 이동합니다</translation>
    </message>
    <message>
        <source>P&amp;osition at Pointer</source>
        <translation>포인터 위치(&amp;O)</translation>
    </message>
    <message>
        <source>Show the coordinates under the pointer, and the line that cut this point</source>
        <translation>포인터 아래의 좌표와 그 지점을 절삭한 줄을 표시합니다</translation>
    </message>
    <message>
        <source>Toolpath Through Stoc&amp;k</source>
        <translation>소재를 투과하는 공구 경로(&amp;K)</translation>
    </message>
    <message>
        <source>Show the toolpath inside and behind the stock, dimmed</source>
        <translation>소재 안과 뒤의 공구 경로를 흐리게 표시합니다</translation>
    </message>
    <message>
        <source>Show the whole stock and its fixtures</source>
        <translation>소재 전체와 고정구를 표시합니다</translation>
    </message>
    <message>
        <source>Fi&amp;xtures</source>
        <translation>고정구(&amp;X)</translation>
    </message>
    <message>
        <source>Draw what holds the stock</source>
        <translation>소재를 고정하는 것을 그립니다</translation>
    </message>
    <message>
        <source>Hide C&amp;ontact</source>
        <translation>접촉 숨기기(&amp;O)</translation>
    </message>
    <message>
        <source>Show the cutter at the end of the block again</source>
        <translation>공구를 다시 블록 끝에 표시합니다</translation>
    </message>
    <message>
        <source>Colour b&amp;y Deviation</source>
        <translation>편차별 색상(&amp;Y)</translation>
    </message>
    <message>
        <source>Colour the stock by its deviation from the design part</source>
        <translation>설계 형상과의 편차에 따라 소재에 색을 입힙니다</translation>
    </message>
    <message>
        <source>De&amp;sign Part</source>
        <translation>설계 형상(&amp;S)</translation>
    </message>
    <message>
        <source>Draw the design part, see-through</source>
        <translation>설계 형상을 반투명하게 그립니다</translation>
    </message>
</context>
<context>
    <name>WaiveDialog</name>
    <message>
        <source>Waive a Finding</source>
        <translation>항목 예외 처리</translation>
    </message>
    <message>
        <source>&amp;Waive</source>
        <translation>예외 처리(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>사유(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Person</source>
        <translation>담당자(&amp;P)</translation>
    </message>
    <message>
        <source>It no longer counts in the verdict. If its block, size, tool or cutter changes, it counts again. The job file keeps the waiver.</source>
        <translation>더 이상 판정에 포함되지 않습니다. 블록, 크기, 공구 번호 또는 공구 형상이 바뀌면 다시 포함됩니다. 예외는 작업 파일에 저장됩니다.</translation>
    </message>
</context>
<context>
    <name>WindowCommands</name>
    <message>
        <source>&amp;Full Screen</source>
        <translation>전체 화면(&amp;F)</translation>
    </message>
    <message>
        <source>Enter or leave full screen</source>
        <translation>전체 화면을 켜거나 끕니다</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>배치 초기화(&amp;R)</translation>
    </message>
    <message>
        <source>Restore the default panels and view options</source>
        <translation>패널과 보기 옵션을 기본값으로 되돌립니다</translation>
    </message>
</context>
<context>
    <name>WindowToolBar</name>
    <message>
        <source>Toolbar</source>
        <translation>도구 모음</translation>
    </message>
</context>
<context>
    <name>WordTip</name>
    <message>
        <source>Value: %1</source>
        <translation>값: %1</translation>
    </message>
    <message>
        <source>Not set</source>
        <translation>설정되지 않음</translation>
    </message>
    <message>
        <source>After this line: %1</source>
        <translation>이 줄 다음: %1</translation>
    </message>
    <message>
        <source>Active before and after: %1</source>
        <translation>이전과 이후 유효: %1</translation>
    </message>
    <message>
        <source>Active before: %1</source>
        <translation>이전 유효: %1</translation>
    </message>
    <message>
        <source>This line is not executed</source>
        <translation>이 줄은 실행되지 않습니다</translation>
    </message>
    <message>
        <source>First of %1 executions</source>
        <translation>%1회 실행 중 첫 번째</translation>
    </message>
</context>
<context>
    <name>WorkHub</name>
    <message>
        <source>Simulating</source>
        <translation>시뮬레이션 중</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>내보내는 중</translation>
    </message>
    <message>
        <source>Reading the program</source>
        <translation>프로그램 읽는 중</translation>
    </message>
    <message>
        <source>Saving the file</source>
        <translation>파일 저장 중</translation>
    </message>
    <message>
        <source>Opening the file</source>
        <translation>파일 여는 중</translation>
    </message>
    <message>
        <source>Searching for the block</source>
        <translation>블록을 찾는 중</translation>
    </message>
</context>
</TS>

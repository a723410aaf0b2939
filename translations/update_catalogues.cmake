# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DLUPDATE=… -DSOURCE_DIR=… -DCATALOGUES=FOLDER -P update_catalogues.cmake
# Extracts the strings of core, ui and app into the catalogues of FOLDER and drops those that are gone.
file(GLOB catalogues "${CATALOGUES}/proveout_*.ts")
set(plural_only "${CATALOGUES}/proveout_en.ts")
list(REMOVE_ITEM catalogues "${plural_only}")

# Without locations a catalogue changes only where a string does.
set(options -locations none -no-obsolete -no-ui-lines
  -tr-function-alias QT_TRANSLATE_NOOP+=PROVEOUT_TEXT)
set(folders core ui app)
execute_process(
  COMMAND "${LUPDATE}" ${options} ${folders} -ts ${catalogues}
  WORKING_DIRECTORY "${SOURCE_DIR}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND "${LUPDATE}" ${options} -pluralonly ${folders} -ts "${plural_only}"
  WORKING_DIRECTORY "${SOURCE_DIR}" COMMAND_ERROR_IS_FATAL ANY)

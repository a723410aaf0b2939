# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DPRESET=… -P run_preset.cmake, in the folder of CMakePresets.json.
execute_process(COMMAND "${CMAKE_COMMAND}" --preset ${PRESET} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build --preset ${PRESET} --target brief_tests COMMAND_ERROR_IS_FATAL ANY)
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
execute_process(COMMAND "${CMAKE_CTEST_COMMAND}" --preset ${PRESET} -L brief --parallel ${cores} COMMAND_ERROR_IS_FATAL ANY)

# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DPRESET=… -P run_preset.cmake, in the folder of CMakePresets.json.
foreach(step --preset "--build --preset")
  separate_arguments(options UNIX_COMMAND "${step}")
  execute_process(COMMAND "${CMAKE_COMMAND}" ${options} ${PRESET} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
execute_process(COMMAND "${CMAKE_CTEST_COMMAND}" --preset ${PRESET} --parallel ${cores} COMMAND_ERROR_IS_FATAL ANY)

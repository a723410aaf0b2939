# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DCLANG=… -P run_fuzz.cmake, in the folder of CMakePresets.json: a short run. Runs with the
# same seed can still differ, because libFuzzer also uses the clock. Findings are printed as Base64.
if(NOT CLANG)
  message("skipped: clang++ is not installed")
  return()
endif()
execute_process(COMMAND "${CLANG}" -print-file-name=libclang_rt.fuzzer-x86_64.a OUTPUT_VARIABLE runtime
  OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT EXISTS "${runtime}")
  message("skipped: the run-time library of libFuzzer is not installed")
  return()
endif()
foreach(step "--preset" "--build --preset")
  separate_arguments(options UNIX_COMMAND "${step}")
  execute_process(COMMAND "${CMAKE_COMMAND}" ${options} fuzz COMMAND_ERROR_IS_FATAL ANY)
endforeach()
set(folder build/fuzz/tests/fuzz)
file(REMOVE_RECURSE ${folder}/found)
file(MAKE_DIRECTORY ${folder}/found) # the fuzzer writes into the first folder
execute_process(
  COMMAND ${folder}/interpreter_fuzz -seed=1 -runs=20000 -max_len=2048 -timeout=10 -entropic=0 -rss_limit_mb=2048
    -dict=${folder}/nc.dict -artifact_prefix=${folder}/ -print_final_stats=1 ${folder}/found ${folder}/seeds
  COMMAND_ERROR_IS_FATAL ANY)

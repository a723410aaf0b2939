# SPDX-License-Identifier: GPL-3.0-or-later
# Run by cmake -P with SOURCE (of the repository) and BINARY (a folder of its own): finds the libraries of
# this computer in each of the ways in which they can be installed.
set(project "${SOURCE}/tests/resources/cmake/project")
set(zstd "zstd LEAST 1.0 TARGET zstd::libzstd_shared PACKAGE libzstd-dev ALSO zstd::libzstd CONFIGS zstd \
MODULES libzstd HEADER zstd.h LIBRARIES zstd VERSION_MACRO ZSTD_VERSION")
set(no_package -DCMAKE_DISABLE_FIND_PACKAGE_zstd=ON)
set(no_module -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON)

# expect(CASE LIBRARY TEXT [option…]): configures a project that needs the library; its output must contain the text.
function(expect case library text)
  file(REMOVE_RECURSE "${BINARY}/${case}")
  execute_process(COMMAND "${CMAKE_COMMAND}" -S "${project}" -B "${BINARY}/${case}"
    "-DFIND_LIBRARY=${SOURCE}/resources/cmake/find_library.cmake" "-DLIBRARY=${library}" ${ARGN}
    OUTPUT_VARIABLE printed ERROR_VARIABLE printed)
  string(REGEX REPLACE "[ \n]+" " " printed "${printed}") # messages are wrapped
  if(NOT "${printed}" MATCHES "${text}")
    message(SEND_ERROR "${case}: \"${text}\" is not in\n${printed}")
  endif()
endfunction()

# works(CASE TEXT [option…]): the library must also be usable.
function(works case text)
  expect(${case} "${zstd}" "${text}" -DPROGRAM=ON ${ARGN})
  execute_process(COMMAND "${CMAKE_COMMAND}" --build "${BINARY}/${case}" OUTPUT_VARIABLE printed ERROR_VARIABLE printed
    RESULT_VARIABLE built)
  execute_process(COMMAND "${BINARY}/${case}/program" RESULT_VARIABLE ran)
  if(NOT built EQUAL 0 OR NOT ran EQUAL 0)
    message(SEND_ERROR "${case}: built ${built}, ran ${ran}\n${printed}")
  endif()
endfunction()

works(package "Found zstd: [0-9.]+ .CMake package zstd.")
works(module "Found zstd: [0-9.]+ .pkg-config module libzstd." ${no_package})
works(plain "Found zstd: [0-9.]+ .header in [^ ]+." ${no_package} ${no_module})

set(old "zstd ([0-9.]+) is too old: version 99 or newer is needed .found: [^)]+.. On Debian 12 or newer: apt install libzstd-dev")
string(REPLACE "LEAST 1.0" "LEAST 99" new_zstd "${zstd}")
expect(old-package "${new_zstd}" "${old}")
expect(old-module "${new_zstd}" "${old}" ${no_package})
expect(old-plain "${new_zstd}" "${old}" ${no_package} ${no_module})
expect(missing "nothing LEAST 1.2 TARGET no::thing PACKAGE libnothing-dev CONFIGS nothing MODULES nothing \
HEADER nothing.h LIBRARIES nothing"
  "nothing was not found; version 1.2 or newer is needed. .*On Debian 12 or newer: apt install libnothing-dev")
# A library with the right name that was built against another version of Qt.
file(MAKE_DIRECTORY "${BINARY}/made")
file(WRITE "${BINARY}/made/libwrong.so" "needs libQt5Widgets.so.5")
file(WRITE "${BINARY}/made/wrong.h" "#define WRONG_VERSION 0x020100\n")
set(wrong "wrong LEAST 1.0 TARGET wrong::wrong PACKAGE libwrong-dev HEADER wrong.h LIBRARIES wrong VERSION_MACRO WRONG_VERSION")
expect(wrong "${wrong} WITHOUT libQt5" "wrong was not found" "-DCMAKE_PREFIX_PATH=${BINARY}/made"
  "-DCMAKE_INCLUDE_PATH=${BINARY}/made" "-DCMAKE_LIBRARY_PATH=${BINARY}/made")
expect(right "${wrong} WITHOUT libQt4" "Found wrong: 2.1.0 " "-DCMAKE_INCLUDE_PATH=${BINARY}/made"
  "-DCMAKE_LIBRARY_PATH=${BINARY}/made")
# The formats in which headers define their versions.
foreach(form "9.8.7:FORM_VERSION_STR \"9.8.7\"" "9.8.7:FORM_VERSION 90807" "9.8.7:FORM_VERSION\\t0x090807"
    "9.8.7:FORM_VERSION_MAJOR\\t9\n#define FORM_VERSION_MINOR 8\n#  define FORM_VERSION_RELEASE 7"
    "version not known:SOMETHING_ELSE 1")
  string(REGEX MATCH "^[^:]+" expected "${form}")
  string(REGEX REPLACE "^[^:]+:" "" lines "${form}")
  string(REPLACE "\\t" "\t" lines "${lines}")
  file(WRITE "${BINARY}/made/form.h" "#define ${lines}\n")
  expect(form "form LEAST 1.0 TARGET form::form PACKAGE form HEADER form.h VERSION_MACRO FORM_VERSION"
    "Found form: ${expected} " "-DCMAKE_INCLUDE_PATH=${BINARY}/made")
endforeach()

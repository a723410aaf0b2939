# SPDX-License-Identifier: GPL-3.0-or-later
# What Proveout is built from, each with its least version: that of Debian 12, the oldest that is tested. Change them
# here alone. The compiler: C++20 as of GCC 12.
include("${CMAKE_CURRENT_LIST_DIR}/find_library.cmake")

set(PROVEOUT_LEAST_QT 6.4)

find_package(Threads REQUIRED)
proveout_find(glm LEAST 0.9.9 TARGET glm::glm PACKAGE libglm-dev
  CONFIGS glm MODULES glm HEADER glm/glm.hpp VERSION_MACRO GLM_VERSION VERSION_HEADER glm/detail/setup.hpp)
proveout_find(fmt LEAST 9.0 TARGET fmt::fmt PACKAGE libfmt-dev
  CONFIGS fmt MODULES fmt HEADER fmt/format.h LIBRARIES fmt VERSION_MACRO FMT_VERSION VERSION_HEADER fmt/core.h)
proveout_find(expected LEAST 1.0 TARGET tl::expected PACKAGE libexpected-dev
  CONFIGS tl-expected HEADER tl/expected.hpp VERSION_MACRO TL_EXPECTED_VERSION)
proveout_find(oneTBB LEAST 2021.5 TARGET TBB::tbb PACKAGE libtbb-dev
  CONFIGS TBB MODULES tbb HEADER oneapi/tbb/version.h LIBRARIES tbb VERSION_MACRO TBB_VERSION)
proveout_find(OpenMesh LEAST 9.0 TARGET OpenMeshCore PACKAGE libopenmesh-dev
  CONFIGS OpenMesh MODULES openmesh HEADER OpenMesh/Core/System/config.h LIBRARIES OpenMeshCore VERSION_MACRO OM_VERSION)
proveout_find(Highway LEAST 1.0.3 TARGET hwy::hwy PACKAGE libhwy-dev
  CONFIGS hwy MODULES libhwy HEADER hwy/highway.h LIBRARIES hwy VERSION_MACRO HWY)
proveout_find(nlohmann-json LEAST 3.11 TARGET nlohmann_json::nlohmann_json PACKAGE nlohmann-json3-dev
  CONFIGS nlohmann_json MODULES nlohmann_json HEADER nlohmann/json.hpp VERSION_MACRO NLOHMANN_JSON_VERSION
  VERSION_HEADER nlohmann/detail/abi_macros.hpp)
proveout_find(CLI11 LEAST 2.1 TARGET CLI11::CLI11 PACKAGE libcli11-dev
  CONFIGS CLI11 MODULES CLI11 HEADER CLI/CLI.hpp VERSION_MACRO CLI11_VERSION VERSION_HEADER CLI/Version.hpp)
proveout_find(tomlplusplus LEAST 3.3 TARGET tomlplusplus::tomlplusplus PACKAGE libtomlplusplus-dev
  CONFIGS tomlplusplus MODULES tomlplusplus HEADER toml++/toml.h VERSION_MACRO TOML_LIB
  VERSION_HEADER toml++/impl/version.h)
proveout_find(zstd LEAST 1.5 TARGET zstd::libzstd_shared PACKAGE libzstd-dev
  ALSO zstd::libzstd zstd::libzstd_static CONFIGS zstd MODULES libzstd HEADER zstd.h LIBRARIES zstd
  VERSION_MACRO ZSTD_VERSION)
find_package(LibArchive 3.6 REQUIRED) # its module comes with CMake, and searches plainly
proveout_find(png LEAST 1.6 TARGET PNG::PNG PACKAGE libpng-dev MODULES libpng HEADER png.h LIBRARIES png
  VERSION_MACRO PNG_LIBPNG_VER_STRING VERSION_HEADER png.h)
proveout_find(nettle LEAST 3.8 TARGET nettle::nettle PACKAGE nettle-dev
  MODULES nettle HEADER nettle/sha2.h LIBRARIES nettle VERSION_MACRO NETTLE_VERSION VERSION_HEADER nettle/version.h)

if(PROVEOUT_UI)
  find_package(Qt6 ${PROVEOUT_LEAST_QT} REQUIRED
    COMPONENTS Core Gui Widgets OpenGL OpenGLWidgets Svg PrintSupport LinguistTools)
  # "libQt5": the same header and name may belong to one that was built for Qt 5.
  proveout_find(QCustomPlot LEAST 2.1 TARGET QCustomPlotQt6::QCustomPlotQt6 PACKAGE libqcustomplot-dev
    CONFIGS QCustomPlotQt6 MODULES qcustomplot-qt6 HEADER qcustomplot.h
    LIBRARIES QCustomPlotQt6 qcustomplot-qt6 qcustomplotQt6 qcustomplot6 QCustomPlot qcustomplot WITHOUT libQt5
    USES Qt6::Widgets Qt6::PrintSupport VERSION_MACRO QCUSTOMPLOT_VERSION)
  proveout_find(QScintilla LEAST 2.13 TARGET proveout_qscintilla PACKAGE libqscintilla2-qt6-dev
    HEADER Qsci/qsciscintilla.h LIBRARIES qscintilla2_qt6 WITHOUT libQt5
    USES Qt6::Widgets Qt6::PrintSupport VERSION_MACRO QSCINTILLA_VERSION VERSION_HEADER Qsci/qsciglobal.h)
endif()

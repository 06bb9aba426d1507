# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the module on its own, against an installed ParaView (module, plugin, Python) or VTK
# (module, Python). Everything is found here, at the root's scope: targets that are imported inside
# the module's folder are not seen by the Python wrapping.

set(BUILD_SHARED_LIBS ON)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR})
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR})
# From the library folder and from the Python package in it; then wherever VTK was found.
set(CMAKE_INSTALL_RPATH $ORIGIN $ORIGIN/../../..)
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)

find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
if (INSIDEOUT_USE_PARAVIEW)
  find_package(ParaView 5.11 REQUIRED)
  set(INSIDEOUT_VTK_PACKAGE ParaView)
  set(INSIDEOUT_VTK_VERSION ${ParaView_VERSION})
  paraview_plugin_scan(
    PLUGIN_FILES      ${PROJECT_SOURCE_DIR}/Plugin/paraview.plugin
    PROVIDES_PLUGINS  plugins
    REQUIRES_MODULES  required_modules
    ENABLE_BY_DEFAULT ON)
else ()
  file(GLOB vtk_of_paraview "/usr/lib*/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-*/vtk") # where there is no other
  find_package(VTK 9.1 REQUIRED
    COMPONENTS
      CommonCore CommonDataModel CommonExecutionModel CommonMisc FiltersCore ImagingCore IOCore IOXML ParallelCore
      WrappingPythonCore Python
    PATHS ${vtk_of_paraview})
  set(INSIDEOUT_VTK_PACKAGE VTK)
  set(INSIDEOUT_VTK_VERSION ${VTK_VERSION})
  # scikit-build-core names the wheel after the VTK that Python finds.
  if (SKBUILD AND NOT SKBUILD_PROJECT_VERSION_FULL MATCHES "\\+vtk${VTK_MAJOR_VERSION}\\.${VTK_MINOR_VERSION}$")
    message(FATAL_ERROR "The wheel is ${SKBUILD_PROJECT_VERSION_FULL}, but CMake found VTK ${VTK_VERSION}: set VTK_DIR or PYTHONPATH")
  endif ()
  set(vtk_python_folder :${VTK_PREFIX_PATH}/${VTK_PYTHONPATH})
endif ()

# vtk_module_build adds each module's folder, which cannot be the project's root: give it one in the
# build tree that holds the same module file.
set(module_folder ${CMAKE_CURRENT_BINARY_DIR}/module)
configure_file(${PROJECT_SOURCE_DIR}/vtk.module ${module_folder}/vtk.module COPYONLY)
file(WRITE ${module_folder}/CMakeLists.txt
  "include(${PROJECT_SOURCE_DIR}/Filters/CMakeLists.txt)\n")
vtk_module_scan(
  MODULE_FILES     ${module_folder}/vtk.module
  REQUEST_MODULES  VTK::FiltersInsideOut ${required_modules}
  PROVIDES_MODULES modules)

set(INSIDEOUT_CMAKE_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/InsideOut)
set(INSIDEOUT_PYTHON_DESTINATION
  ${CMAKE_INSTALL_LIBDIR}/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/site-packages
  CACHE STRING "Where the Python package goes below the prefix")
# Python's path in the build tree: the package, and the VTK that it was built with.
set(INSIDEOUT_PYTHON_PATH ${CMAKE_BINARY_DIR}/${INSIDEOUT_PYTHON_DESTINATION}${vtk_python_folder})
vtk_module_build(
  MODULES             ${modules}
  PACKAGE             InsideOut
  INSTALL_EXPORT      InsideOut
  HEADERS_DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/InsideOut
  CMAKE_DESTINATION   ${INSIDEOUT_CMAKE_DESTINATION}
  VERSION             ${PROJECT_VERSION}
  SOVERSION           ${PROJECT_VERSION_MAJOR})
# Precompiled headers for most classes. The target behind the module's name has the library's from
# VTK 9.7 on (its release notes, "Build": "Name targets after library names").
get_target_property(module_target VTK::FiltersInsideOut ALIASED_TARGET)
target_precompile_headers(${module_target} PRIVATE
  <algorithm> <functional> <map> <string> <vector>
  <vtkCellData.h> <vtkDoubleArray.h> <vtkInformation.h> <vtkInformationVector.h> <vtkObjectFactory.h>
  <vtkPointData.h> <vtkPolyData.h> <vtkSmartPointer.h> <vtkStringArray.h> <vtkUnstructuredGrid.h>)

vtk_module_wrap_python(
  MODULES            ${modules}
  TARGET             InsideOut::Python
  PYTHON_PACKAGE     insideout
  MODULE_DESTINATION ${INSIDEOUT_PYTHON_DESTINATION}
  CMAKE_DESTINATION  ${INSIDEOUT_CMAKE_DESTINATION}
  INSTALL_HEADERS    OFF)
# From VTK 9.7 on it begins with Py (its release notes, "Build": "vtkModuleWrapPython renames Python module targets").
set(INSIDEOUT_WRAPPING vtkFiltersInsideOutPython)
if (TARGET Py${INSIDEOUT_WRAPPING})
  set(INSIDEOUT_WRAPPING Py${INSIDEOUT_WRAPPING})
endif ()
add_subdirectory(Filters/Python)

if (INSIDEOUT_USE_PARAVIEW)
  paraview_plugin_build(
    PLUGINS              ${plugins}
    PLUGINS_FILE_NAME    insideout.plugins.xml
    LIBRARY_SUBDIRECTORY ${PARAVIEW_PLUGIN_SUBDIR}
    INSTALL_HEADERS      OFF)
endif ()

# The wrapping costs next to no time at run time: it is compiled fast rather than optimized.
foreach (wrapping IN ITEMS ${INSIDEOUT_WRAPPING} vtkFiltersInsideOutCS)
  if (TARGET ${wrapping})
    target_compile_options(${wrapping} PRIVATE $<$<CONFIG:Release>:-O1>)
    set_target_properties(${wrapping} PROPERTIES UNITY_BUILD ON)
  endif ()
endforeach ()

# find_package(InsideOut) of another project.
include(CMakePackageConfigHelpers)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/InsideOutConfig.cmake.in
  ${CMAKE_BINARY_DIR}/${INSIDEOUT_CMAKE_DESTINATION}/InsideOutConfig.cmake
  INSTALL_DESTINATION ${INSIDEOUT_CMAKE_DESTINATION})
write_basic_package_version_file(
  ${CMAKE_BINARY_DIR}/${INSIDEOUT_CMAKE_DESTINATION}/InsideOutConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES
  ${CMAKE_BINARY_DIR}/${INSIDEOUT_CMAKE_DESTINATION}/InsideOutConfig.cmake
  ${CMAKE_BINARY_DIR}/${INSIDEOUT_CMAKE_DESTINATION}/InsideOutConfigVersion.cmake
  DESTINATION ${INSIDEOUT_CMAKE_DESTINATION})

# The reference of classes, options and arrays.
set(reference_folder ${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_DOCDIR})
set(reference ${reference_folder}/Reference.md ${reference_folder}/Reference.html)
file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/Filters/vtk*.h)
file(MAKE_DIRECTORY ${reference_folder})
add_custom_command(
  OUTPUT  ${reference}
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/write-reference.py ${PROJECT_SOURCE_DIR}/Filters ${reference}
  DEPENDS ${CMAKE_CURRENT_LIST_DIR}/write-reference.py ${CMAKE_CURRENT_LIST_DIR}/declared_options.py ${headers})
add_custom_target(InsideOutReference ALL DEPENDS ${reference})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${reference}
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
if (INSIDEOUT_USE_TETGEN)
  install(FILES ${PROJECT_SOURCE_DIR}/Filters/Tetgen/LICENSE
    DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME LICENSE.insideout-tetgen)
endif ()
configure_file(${CMAKE_CURRENT_LIST_DIR}/env.sh.in ${CMAKE_BINARY_DIR}/env.sh @ONLY)
include(${CMAKE_CURRENT_LIST_DIR}/Packages.cmake)

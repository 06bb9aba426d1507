#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# build-in-vtk.sh VTK_SOURCE [FOLDER [OPTION...]]: build this tree as a remote module in VTK's own
# build, with only the modules that vtk.module lists. Then import it in Python, and run the tests of
# the classes there. FOLDER (build-in-vtk) gets the builds, CMake the options. VTK's sources stay
# unchanged. VTK takes an hour on two cores.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
vtk=$(cd "$1" && pwd)
folder=${2:-build-in-vtk}
shift
[ $# -eq 0 ] || shift
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)

# VTK's sources and this tree, as links. VTK does not follow them on its search for modules, but looks into folders.
tree=$folder/linked-sources
rm -rf "$tree"
mkdir -p "$tree/Remote/FiltersInsideOut"
for entry in "$vtk"/* "$vtk"/.clang-tidy; do
  [ "$entry" = "$vtk/Remote" ] || ln -s "$entry" "$tree/"
done
ln -s "$vtk"/Remote/* "$tree/Remote/"
ln -s "$source/CMakeLists.txt" "$source/vtk.module" "$source/Filters" "$source/Testing" "$tree/Remote/FiltersInsideOut/"

# Without optimization, and many sources at once: it is to be built soon, not to run fast. Not joined are third parties'
# sources with private headers, and where sources use the same names, those with namespaces of their own. VTK's own macros
# end in semicolons that -Wpedantic refuses.
cat >"$folder/unity.cmake" <<'END'
function (set_apart)
  set_target_properties(vtksys vtkkissfft vtklzma vtkzlib PyvtkIOCellGridPython WrapJavaScript PROPERTIES UNITY_BUILD OFF)
  foreach (module IN ITEMS CommonDataModel CommonExecutionModel FiltersCellGrid FiltersCore IOCore IOLegacy IOXML ImagingCore)
    get_target_property(folder vtk${module} SOURCE_DIR)
    get_target_property(sources vtk${module} SOURCES)
    list(FILTER sources INCLUDE REGEX "^vtk.*\\.cxx$|Instantiate[A-Za-z]+\\.cxx$")
    foreach (source IN LISTS sources)
      get_filename_component(source ${source} ABSOLUTE BASE_DIR ${folder})
      file(STRINGS ${source} lines REGEX "^namespace *({.*|//.*)?$|^#include .*\\.inl\"|_INSTANTIATING$|^static bool registerType")
      if (lines)
        set_property(SOURCE ${source} TARGET_DIRECTORY vtk${module} PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
      endif ()
    endforeach ()
  endforeach ()
endfunction ()
cmake_language(DEFER CALL set_apart)
END
cmake -S "$tree" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_UNITY_BUILD=ON -DVTK_USE_PCH=OFF \
  -DCMAKE_PROJECT_VTK_INCLUDE="$folder/unity.cmake" -DVTK_BUILD_ALL_MODULES=OFF -DVTK_GROUP_ENABLE_StandAlone=DONT_WANT \
  -DVTK_GROUP_ENABLE_Rendering=DONT_WANT -DVTK_ENABLE_LOGGING=OFF -DVTK_BUILD_TESTING=OFF -DVTK_WRAP_PYTHON=ON \
  -DVTK_MODULE_ENABLE_VTK_FiltersInsideOut=YES -DPython3_EXECUTABLE=/usr/bin/python3 \
  "-DINSIDEOUT_WARNINGS=-O1;-Wall;-Wextra;-Werror" "$@" >"$folder/configure.log" 2>&1 ||
  { cat "$folder/configure.log"; exit 1; }
cmake --build "$folder/build"

libraries=$folder/build/lib
packages=$(echo "$libraries"/python3.*/site-packages)
export LD_LIBRARY_PATH="$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
PYTHONPATH=$packages /usr/bin/python3 -c "from vtkmodules.vtkFiltersInsideOut import vtkRobustTetrahedralize
print(vtkRobustTetrahedralize())"

cmake -S "$source/Testing/OtherBuilds/InVtk" -B "$folder/tests" -G Ninja -DCMAKE_BUILD_TYPE=None \
  -DVTK_BUILD="$folder/build" -DVTK_PYTHON_FOLDER="$packages" -DPython3_EXECUTABLE=/usr/bin/python3
cmake --build "$folder/tests"
exec ctest --test-dir "$folder/tests" --output-on-failure --no-tests=error --parallel "$(nproc)"

#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes what is needed to compile this module for the package vtk of PyPI, which has libraries but
# no headers. The folder that this script makes has the headers, the CMake package, the hierarchy
# files and the tools that generate Python wrappers. The libraries are those of the installed wheel,
# so that one folder serves all versions of Python.
#
#   Scripts/make-vtk-sdk.sh VTK_SOURCE PYTHON OUT_FOLDER
#
#   VTK_SOURCE   VTK's source, with the version of the wheel
#   PYTHON       a Python interpreter with its headers, in which that wheel is installed
#   OUT_FOLDER   is made; a folder of this name must not exist
#
# Needed are CMake 3.27, Ninja, and a compiler for C and C++. No library of VTK is compiled but the
# parser of the tools, which takes about two minutes.

set -euo pipefail
export LC_ALL=C

fail() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

(($# == 3)) || fail "usage: make-vtk-sdk.sh VTK_SOURCE PYTHON OUT_FOLDER"
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$(realpath "$1")
python=$2
out=$(realpath -m "$3")
[[ ! -e "$out" ]] || fail "$out exists already"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The wheel: its version, whether std::string is the one of before C++11, and the threads that
# vtkSMPTools uses. They appear in headers, so that the configuration has to be the same.
wheel=$("$python" -c 'import importlib.util as u; print(u.find_spec("vtkmodules").submodule_search_locations[0])') ||
  fail "$python has no package vtk"
library=$wheel/libvtkCommonCore.so
version=$(grep -aoE 'vtk version [0-9.]+' "$library" | sed 's/.* //;q')
in_source=$(sed -nE 's/^set\(VTK_(MAJOR|MINOR|BUILD)_VERSION ([0-9]+)\)/\2/p' \
  "$source/CMake/vtkVersion.cmake" | paste -sd.)
[[ "$version" == "$in_source" ]] || fail "the wheel is VTK $version, the source is VTK $in_source"
nm --dynamic --demangle "$library" >"$work/symbols"
new_strings=0
if grep -q '__cxx11' "$work/symbols"; then
  new_strings=1
fi
if grep -q 'vtkSMPToolsImpl<(vtk::detail::smp::BackendType)[23]>' "$work/symbols"; then
  fail "the wheel uses TBB or OpenMP, and this script knows only VTK's own threads"
fi
printf 'VTK %s, _GLIBCXX_USE_CXX11_ABI=%s\n' "$version" "$new_strings"

# VTK as in .gitlab/ci/configure_wheel.cmake of its source, but only what the module includes. The
# window systems change no header that it includes. Libraries of wheels have no version in their
# names.
options=()
for group in Imaging MPI Qt Rendering StandAlone Views Web; do
  options+=("-DVTK_GROUP_ENABLE_$group=DONT_WANT")
done
for module in CommonCore CommonDataModel CommonExecutionModel CommonMath FiltersGeometry jsoncpp \
  Python RenderingCore RenderingOpenGL2 WrappingPythonCore; do
  options+=("-DVTK_MODULE_ENABLE_VTK_$module=YES")
done
maps="-ffile-prefix-map=$source=VTK -ffile-prefix-map=$work=."
cmake -S "$source" -B "$work/build" -G Ninja "${options[@]}" \
  -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_INSTALL_LIBDIR=lib \
  -DCMAKE_PLATFORM_NO_VERSIONED_SONAME=ON \
  "-DCMAKE_C_FLAGS=$maps" \
  "-DCMAKE_CXX_FLAGS=-D_GLIBCXX_USE_CXX11_ABI=$new_strings $maps" \
  -DPython3_EXECUTABLE="$("$python" -c 'import sys; print(sys.executable)')" \
  -DVTK_BUILD_ALL_MODULES=OFF \
  -DVTK_BUILD_TESTING=OFF \
  -DVTK_CUSTOM_LIBRARY_SUFFIX= \
  -DVTK_DEBUG_LEAKS=OFF \
  -DVTK_DISPATCH_SOA_ARRAYS=ON \
  -DVTK_ENABLE_REMOTE_MODULES=OFF \
  -DVTK_SMP_IMPLEMENTATION_TYPE=STDThread \
  -DVTK_USE_Wayland=OFF \
  -DVTK_USE_X=OFF \
  -DVTK_WRAP_PYTHON=ON

# The tools, the headers that VTK generates, and the hierarchy files.
mapfile -t files < <(ninja -C "$work/build" -t targets all |
  sed -nE 's/^([^/:][^:]*\.(h|hxx|txx|txt)): CUSTOM_COMMAND$/\1/p')
ninja -C "$work/build" Wrapping/Tools/all "${files[@]}"
{
  cmake --install "$work/build" --component development --prefix "$work/sdk"
  cmake --install "$work/build" --component license --prefix "$work/sdk"
  cmake --install "$work/build" --component licenses --prefix "$work/sdk"
  cmake --install "$work/build/Wrapping/Tools" --component runtime --strip --prefix "$work/sdk"
} >"$work/install.log" || fail "VTK could not be installed: $(tail "$work/install.log")"

# The CMake package finds libraries in the wheel, for every Python that has the wheel.
package=$work/sdk/lib/cmake/vtk-${version%.*}
rm "$package"/VTK*-targets-release.cmake
sed -e "s/@VERSION@/$version/g" -e "s/@NEW_STRINGS@/$new_strings/g" \
  "$scripts/vtk-sdk-targets.cmake" >"$package/VTK-targets-wheel.cmake"
sed -i '/find_package(Python3$/{n;s/[0-9.]\+//}' "$package/VTK-vtk-module-find-packages.cmake"

if grep -rlF -e "$work" -e "$source" -e "$wheel" "$work/sdk"; then
  fail "the files above contain paths of this machine"
fi
mkdir -p "$(dirname "$out")"
mv "$work/sdk" "$out"
printf 'made %s\n' "$out"

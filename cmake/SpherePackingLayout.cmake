# Where things are installed, and how they find each other there.
#
# The wrapped modules lie in the Python package, the libraries that they are linked to in its folder
# lib, where Python does not take them for modules, too. In a wheel the install prefix is the
# site-packages folder itself. A plain install uses the folder that the interpreter looks into under
# any prefix: Debian's system Python says dist-packages, others say site-packages.
if (SKBUILD)
  set(_site_dir ".")
else ()
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" -c "
import pathlib, sys, sysconfig
name = pathlib.PurePath(sysconfig.get_path('platlib')).name
print(f'lib/python{sys.version_info.major}.{sys.version_info.minor}/{name}')"
    OUTPUT_VARIABLE _site_dir
    OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
endif ()
set(SPHEREPACKING_SITE_DIR "${_site_dir}" CACHE STRING
  "The folder on Python's path that receives the package, relative to the install prefix")
if (SPHEREPACKING_SITE_DIR STREQUAL ".")
  set(SPHEREPACKING_PYTHON_DIR "spherepacking")
else ()
  set(SPHEREPACKING_PYTHON_DIR "${SPHEREPACKING_SITE_DIR}/spherepacking")
endif ()
set(SPHEREPACKING_LIBRARY_DIR "${SPHEREPACKING_PYTHON_DIR}/lib")

set(SPHEREPACKING_LIBRARY_RPATH "$ORIGIN")
set(SPHEREPACKING_MODULE_RPATH "$ORIGIN/lib")
if (SPHEREPACKING_VTK_PACKAGE STREQUAL "cvista")
  # A wheel finds VTK's libraries in the cvista package next to it.
  list(APPEND SPHEREPACKING_LIBRARY_RPATH "$ORIGIN/../../cvista")
  list(APPEND SPHEREPACKING_MODULE_RPATH "$ORIGIN/../cvista")
endif ()
if (NOT SKBUILD)
  # A plain install stays on this machine: it may name the folder that VTK was linked from. CMake
  # leaves out what the system's loader finds by itself, but also what lies inside the project, as
  # the SDK in .venv does.
  set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
  if (SPHEREPACKING_VTK_PACKAGE STREQUAL "cvista")
    get_target_property(_vtk_library VTK::Common IMPORTED_LOCATION_RELEASE)
    cmake_path(GET _vtk_library PARENT_PATH _vtk_folder)
    list(APPEND SPHEREPACKING_LIBRARY_RPATH "${_vtk_folder}")
    list(APPEND SPHEREPACKING_MODULE_RPATH "${_vtk_folder}")
  endif ()
endif ()

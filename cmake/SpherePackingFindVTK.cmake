# Finds VTK: cvista's when its SDK is installed for Python, stock VTK's otherwise.
#
# scikit-build-core hands the SDK's folder over by itself. In a plain CMake build Python is asked
# for it, because its path contains the Python version, which presets cannot know.
# `-DVTK_DIR=...` wins over both.
if (NOT SKBUILD AND NOT VTK_DIR)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" -c "
import importlib.util
spec = importlib.util.find_spec('cvista_sdk')
print(spec.submodule_search_locations[0] if spec else '')"
    OUTPUT_VARIABLE _cvista_sdk
    OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
  if (_cvista_sdk)
    list(PREPEND CMAKE_PREFIX_PATH "${_cvista_sdk}/cmake")
  endif ()
endif ()

find_package(VTK 9.6 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel FiltersSources
  RenderingCore RenderingOpenGL2 Python WrappingPythonCore)
# The wrapping needs the interpreter only through VTK; the stubs run it.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# The Python package that this VTK is imported as; cvista's config alone defines CVISTA_ABI3.
if (DEFINED CVISTA_ABI3)
  set(SPHEREPACKING_VTK_PACKAGE "cvista")
else ()
  set(SPHEREPACKING_VTK_PACKAGE "vtkmodules")
endif ()
message(STATUS "VTK ${VTK_VERSION} (Python package ${SPHEREPACKING_VTK_PACKAGE}): ${VTK_DIR}")

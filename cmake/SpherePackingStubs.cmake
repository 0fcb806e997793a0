# spherepacking_write_stubs(<module>...)
#
# Runs VTK's own generator on the wrapped modules after they are linked and installs the .pyi files
# and py.typed with them. (The option BUILD_PYI_FILES of vtk_module_wrap_python works only inside
# VTK's own build: it needs targets of that build.) The package is an __init__.py that says where the
# build tree's modules lie, so that nothing else is imported: neither PyVista nor NumPy is needed, as
# in an isolated pip build. Without it a package that is already installed would be described.
function (spherepacking_write_stubs)
  set(_path "${CMAKE_BINARY_DIR}/stubs/package")
  file(CONFIGURE OUTPUT "${_path}/spherepacking/__init__.py"
    CONTENT "__path__ = [r\"${CMAKE_BINARY_DIR}/${SPHEREPACKING_SITE_DIR}/spherepacking\"]\n" @ONLY)
  if (SPHEREPACKING_VTK_PACKAGE STREQUAL "cvista")
    # The SDK carries the importable package with the libraries that the modules were linked to.
    file(GLOB _sdk_generator "${VTK_DIR}/../content/cvista/generate_pyi.py")
    if (NOT _sdk_generator)
      message(FATAL_ERROR "No content/cvista/generate_pyi.py beside ${VTK_DIR}: "
        "expected the layout of cvista-sdk, or configure with -DSPHEREPACKING_STUBS=OFF.")
    endif ()
    cmake_path(GET _sdk_generator PARENT_PATH _sdk_package)
    cmake_path(GET _sdk_package PARENT_PATH _sdk_site)
    set(_path "${_sdk_site}" "${_path}")
    # The SDK keeps its libraries apart from its modules, which only look beside themselves.
    file(GLOB _sdk_libraries LIST_DIRECTORIES true "${_sdk_site}/build/lib.*/cvista")
  endif ()
  set(_modify)
  foreach (_folder IN LISTS _path)
    list(APPEND _modify --modify "PYTHONPATH=path_list_prepend:${_folder}")
  endforeach ()

  foreach (_folder IN LISTS _sdk_libraries)
    list(APPEND _modify --modify "LD_LIBRARY_PATH=path_list_prepend:${_folder}")
  endforeach ()

  set(_names)
  set(_targets)
  foreach (_module IN LISTS ARGN)
    get_property(_name TARGET "${_module}" PROPERTY INTERFACE_vtk_module_library_name)
    list(APPEND _names "${_name}")
    # VTK 9.6 calls the target of the wrapped module <name>Python, 9.7 Py<name>Python.
    if (TARGET "Py${_name}Python")
      list(APPEND _targets "Py${_name}Python")
    else ()
      list(APPEND _targets "${_name}Python")
    endif ()
  endforeach ()
  set(_folder "${CMAKE_BINARY_DIR}/stubs")
  file(MAKE_DIRECTORY "${_folder}")
  list(TRANSFORM _names APPEND ".pyi" OUTPUT_VARIABLE _stubs)
  list(TRANSFORM _stubs PREPEND "${_folder}/")
  list(APPEND _stubs "${_folder}/py.typed")

  set(_script "${CMAKE_SOURCE_DIR}/cmake/import_stub_names.py")
  add_custom_command(
    OUTPUT   ${_stubs}
    COMMAND  "${CMAKE_COMMAND}" -E env ${_modify}
             "${Python3_EXECUTABLE}" -m "${SPHEREPACKING_VTK_PACKAGE}.generate_pyi"
             -p spherepacking -o "${_folder}" ${_names}
    COMMAND  "${CMAKE_COMMAND}" -E env ${_modify}
             "${Python3_EXECUTABLE}" "${_script}"
             "${SPHEREPACKING_VTK_PACKAGE}" spherepacking "${_folder}" ${_names}
    DEPENDS  ${_targets} "${_script}"
    COMMENT  "Writing stubs of the wrapped modules"
    VERBATIM)
  add_custom_target(spherepacking_stubs ALL DEPENDS ${_stubs})
  install(FILES ${_stubs} DESTINATION "${SPHEREPACKING_PYTHON_DIR}")
endfunction ()

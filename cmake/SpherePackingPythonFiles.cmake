# What scikit-build-core does for the wheel, for a plain install: the Python sources, the metadata
# through which PyVista finds the plugin, and the command.
install(DIRECTORY "${CMAKE_SOURCE_DIR}/python/spherepacking/"
  DESTINATION "${SPHEREPACKING_PYTHON_DIR}"
  PATTERN "__pycache__" EXCLUDE)

set(_script "${CMAKE_SOURCE_DIR}/cmake/write_metadata.py")
set(_pyproject "${CMAKE_SOURCE_DIR}/pyproject.toml")
set(_info "${CMAKE_BINARY_DIR}/metadata/spherepacking-${PROJECT_VERSION}.dist-info")
set(_command "${CMAKE_BINARY_DIR}/metadata/spherepacking")
set(_files "${_info}/METADATA" "${_info}/entry_points.txt" "${_info}/INSTALLER" "${_command}")
add_custom_command(
  OUTPUT   ${_files}
  COMMAND  "${Python3_EXECUTABLE}" "${_script}" "${_pyproject}" "${PROJECT_VERSION}"
           "${CMAKE_BINARY_DIR}/metadata"
  DEPENDS  "${_script}" "${_pyproject}"
  COMMENT  "Writing the package's metadata"
  VERBATIM)
add_custom_target(spherepacking_metadata ALL DEPENDS ${_files})
install(DIRECTORY "${_info}" DESTINATION "${SPHEREPACKING_SITE_DIR}")
install(PROGRAMS "${_command}" DESTINATION "${CMAKE_INSTALL_BINDIR}")

# SPDX-License-Identifier: GPL-3.0-or-later
# The command, which env.sh puts on PATH, its page in the manual, and Debian's package of it all: with package-deb.sh beside this file.
set(INSIDEOUT_COMMAND ${CMAKE_BINARY_DIR}/insideout)
file(WRITE ${INSIDEOUT_COMMAND}
  "#!/bin/sh\n# SPDX-License-Identifier: GPL-3.0-or-later\nexec \"${Python3_EXECUTABLE}\" -m insideout \"$@\"\n")
file(COPY ${INSIDEOUT_COMMAND} DESTINATION ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
install(PROGRAMS ${INSIDEOUT_COMMAND} DESTINATION ${CMAKE_INSTALL_BINDIR})

# The page is the output of --help-all.
set(manual_page ${CMAKE_BINARY_DIR}/insideout.1)
file(GLOB sources_of_help CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/Filters/Python/insideout/*.py) # a target is no reason to make it again
add_custom_command(
  OUTPUT  ${manual_page}
  COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${INSIDEOUT_PYTHON_PATH}
    ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/write-man-page.py ${manual_page}
  DEPENDS InsideOutPythonFiles ${CMAKE_CURRENT_LIST_DIR}/write-man-page.py ${sources_of_help})
add_custom_target(InsideOutManualPage ALL DEPENDS ${manual_page})
install(FILES ${manual_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME insideout)
set(CPACK_PACKAGE_VENDOR InsideOut)
set(CPACK_PACKAGE_CONTACT "InsideOut <insideout@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "tetrahedra of the solid that a broken triangle surface means")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# dpkg-shlibdeps finds the module's own library at its place in the package.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON) # and with it ldconfig is run
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3-numpy")
# With ParaView and without it: two packages with the same files, of which one can be installed.
if (INSIDEOUT_USE_PARAVIEW)
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", paraview, python3-paraview")
  set(other_package insideout-vtk)
  # Register the plugin with ParaView, and unregister it.
  foreach (script IN ITEMS postinst prerm)
    set(control_file ${CMAKE_BINARY_DIR}/deb/${script})
    configure_file(${CMAKE_CURRENT_LIST_DIR}/deb-${script}.in ${control_file} @ONLY)
    list(APPEND CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${control_file})
  endforeach ()
else ()
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", python3-vtk9")
  set(CPACK_PACKAGE_NAME insideout-vtk)
  set(other_package insideout)
endif ()
set(CPACK_DEBIAN_PACKAGE_CONFLICTS ${other_package})
set(CPACK_DEBIAN_PACKAGE_REPLACES ${other_package})
include(CPack)

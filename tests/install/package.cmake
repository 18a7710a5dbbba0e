# Makes the Debian packages of BUILD in FOLDER, looks at what they say of themselves, and unpacks them in FOLDER/root.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER}/root)
execute_process(COMMAND ${CPACK} -G DEB -B ${FOLDER} WORKING_DIRECTORY ${BUILD} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)

# expect_field(PACKAGE FIELD EXPECTED): the field of the control file matches the regular expression.
function(expect_field package field expected)
  file(GLOB file ${FOLDER}/${package}_${VERSION}_*.deb)
  execute_process(COMMAND dpkg-deb --field ${file} ${field} OUTPUT_VARIABLE value COMMAND_ERROR_IS_FATAL ANY)
  if(NOT value MATCHES "${expected}")
    message(FATAL_ERROR "${package}: ${field} is\n${value}instead of something that matches\n${expected}")
  endif()
endfunction()

expect_field(scatter Version "^${VERSION}\n$")
expect_field(scatter Maintainer "^Scatter maintainers <")
expect_field(scatter Description "^lab for collision overload")
# What the program links; Bullet's packages are named by their version.
expect_field(scatter Depends "libbullet.*libc6.*libpugixml")
expect_field(libscatter-dev Depends "libbullet-dev.*libglm-dev.*libqhull-dev")
file(GLOB packages ${FOLDER}/*.deb)
foreach(package IN LISTS packages)
  execute_process(COMMAND dpkg-deb --extract ${package} ${FOLDER}/root COMMAND_ERROR_IS_FATAL ANY)
endforeach()
foreach(package scatter libscatter-dev)
  if(NOT EXISTS ${FOLDER}/root/usr/share/doc/${package}/copyright)
    message(FATAL_ERROR "${package} has no licence in /usr/share/doc/${package}/copyright")
  endif()
endforeach()

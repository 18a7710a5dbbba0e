# Installs BUILD, then moves the tree to PREFIX: an installed package must not depend on where it was put first.
file(REMOVE_RECURSE ${PREFIX} ${PREFIX}-first)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}-first
                COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
file(RENAME ${PREFIX}-first ${PREFIX})
file(COPY_FILE ${PREFIX}/share/scatter/scenes/tower.toml ${PREFIX}/share/scatter/scenes/only_installed.toml)

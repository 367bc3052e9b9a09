# Installs BUILD_TREE into an empty PREFIX.
file(REMOVE_RECURSE "${PREFIX}")
execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD_TREE}" --prefix "${PREFIX}"
  COMMAND_ERROR_IS_FATAL ANY)

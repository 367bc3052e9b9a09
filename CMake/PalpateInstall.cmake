# Installs the kernels and the package files; the VTK modules install themselves.

include(CMakePackageConfigHelpers)
install(EXPORT PalpateKernels NAMESPACE Palpate:: FILE PalpateKernels-targets.cmake
  DESTINATION "${PALPATE_VTK_CMAKE_DIR}" COMPONENT development)
export(EXPORT PalpateKernels NAMESPACE Palpate::
  FILE "${CMAKE_BINARY_DIR}/${PALPATE_VTK_CMAKE_DIR}/PalpateKernels-targets.cmake")
string(REPLACE ";" " " PALPATE_KERNEL_LIST "${PALPATE_KERNEL_MODULES}")
configure_package_config_file(CMake/PalpateConfig.cmake.in
  "${CMAKE_BINARY_DIR}/${PALPATE_VTK_CMAKE_DIR}/PalpateConfig.cmake"
  INSTALL_DESTINATION "${PALPATE_VTK_CMAKE_DIR}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${PALPATE_VTK_CMAKE_DIR}/PalpateConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_BINARY_DIR}/${PALPATE_VTK_CMAKE_DIR}/PalpateConfig.cmake"
  "${CMAKE_BINARY_DIR}/${PALPATE_VTK_CMAKE_DIR}/PalpateConfigVersion.cmake"
  DESTINATION "${PALPATE_VTK_CMAKE_DIR}" COMPONENT development)
install(PROGRAMS Utilities/install-udev-rule.sh DESTINATION ${CMAKE_INSTALL_DATADIR}/palpate)
install(FILES Utilities/70-palpate-falcon.rules DESTINATION ${CMAKE_INSTALL_DATADIR}/palpate)
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")

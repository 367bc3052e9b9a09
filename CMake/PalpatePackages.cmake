# Packages by CPack, from the components kernels, runtime, viewer, development, python and filters.
# Utilities/packages.sh makes and checks them; CMake/PalpateDebian.cmake adds what Debian alone wants.

set(CPACK_PACKAGE_NAME palpate)
set(CPACK_PACKAGE_CONTACT "The Palpate authors <palpate@lists.invalid>")
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL kernels runtime development)
if(PALPATE_HAS_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python filters)
endif()
if(PALPATE_HAS_QT)
  list(APPEND CPACK_COMPONENTS_ALL viewer)
endif()
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/CMake/PalpateDebian.cmake")

# palpate_debian_package(COMPONENT package section depends summary text)
macro(palpate_debian_package component package section depends summary text)
  set(CPACK_DEBIAN_${component}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${component}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${component}_PACKAGE_DEPENDS "${depends}")
  set(CPACK_DEBIAN_${component}_DESCRIPTION "${summary}\n${text}")
endmacro()
set(kernels "libpalpate1 (= ${PROJECT_VERSION})")
set(ours "palpate (= ${PROJECT_VERSION})")
palpate_debian_package(KERNELS libpalpate1 libs ""
  "spherical-harmonic organ models - shared libraries without VTK"
  "Spherical harmonics, fields of voxels, contact, forces and haptic devices, with
an interface for C. The package palpate has the programs.")
palpate_debian_package(RUNTIME palpate science "${kernels}"
  "spherical-harmonic organ models from segmentations"
  "Turns organs in segmented MR and CT volumes into compact surface models,
measures how well they fit, draws them, and computes the forces of touching
them with a haptic device. Includes command-line modules for 3D Slicer.
Not a medical device.")
palpate_debian_package(VIEWER palpate-viewer science "${ours}"
  "see and touch organs in volumes and segmentations"
  "A window with linked slices and a 3D view, in which organs are fitted to
models and touched with a haptic device or the mouse.")
palpate_debian_package(DEVELOPMENT libpalpate-dev libdevel
  "${ours}, libvtk9-dev, libeigen3-dev, nlohmann-json3-dev"
  "spherical-harmonic organ models - development files"
  "Headers and CMake package of Palpate's libraries: spherical harmonics,
fields of voxels, contact and forces, and filters for VTK.")
# The modules are compiled for one version of Python.
if(PALPATE_HAS_PYTHON)
  math(EXPR next "${Python3_VERSION_MINOR} + 1")
  set(python "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next})")
endif()
palpate_debian_package(PYTHON python3-palpate python "${kernels}, ${python}, python3-numpy"
  "spherical-harmonic organ models - Python 3"
  "Fits, evaluates and touches organ models over NumPy arrays, without VTK.")
palpate_debian_package(FILTERS python3-palpate-vtk python
  "python3-palpate (= ${PROJECT_VERSION}), ${ours}, ${python}, python3-vtk9"
  "spherical-harmonic organ models - VTK filters for Python 3"
  "Palpate's VTK filters in the Python package palpate.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-palpate-vtk, python3-vtk9")
set(CPACK_DEBIAN_KERNELS_PACKAGE_RECOMMENDS libopenblas0-pthread)
set(CPACK_DEBIAN_KERNELS_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/Packaging/triggers")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "palpate-viewer, mricron-data")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/Packaging/triggers")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
include(CPack)

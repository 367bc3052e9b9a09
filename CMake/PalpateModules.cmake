# The modules without VTK, ITK and Qt, each after those that it uses.
set(PALPATE_KERNEL_MODULES
  Core Mesh Harmonics Statistics ShapeSpace Registration Field Realtime Elasticity Contact Files Model Check Relation
  Haptics HapticDevices CInterface)
if(OpenIGTLink_FOUND)
  list(INSERT PALPATE_KERNEL_MODULES 1 Network)
endif()

# The VTK modules: scanned from their vtk.module files, built and installed by VTK's module system.

set(palpate_vtk_modules IO Filters VolumeRendering Display Interaction Report Fit Group Comparison Scene Task Trade
  Study)
if(PALPATE_BUILD_PARAVIEW)
  set(PALPATE_KERNEL_MODULES Core Mesh Harmonics Field Elasticity Contact Model Files)
  set(palpate_vtk_modules IO Filters VolumeRendering Display Report Fit ParaView)
endif()
set(PALPATE_VTK_MODULE_FILES)
foreach(module IN LISTS palpate_vtk_modules)
  list(APPEND PALPATE_VTK_MODULE_FILES "${CMAKE_CURRENT_SOURCE_DIR}/Modules/${module}/vtk.module")
endforeach()
# Classes of C++ change from one minor version to the next; the C library has its own (Modules/CInterface).
set(PALPATE_CXX_SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(PALPATE_VTK_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/Palpate")

# A macro, so that variables set by VTK's functions stay visible in the caller.
macro(palpate_build_vtk_modules)
  vtk_module_scan(
    MODULE_FILES ${PALPATE_VTK_MODULE_FILES}
    PROVIDES_MODULES PALPATE_MODULES
    WANT_BY_DEFAULT ON
    REQUIRES_MODULES palpate_required_modules)
  vtk_module_build(
    MODULES ${PALPATE_MODULES}
    INSTALL_EXPORT PalpateModules
    PACKAGE Palpate
    # Tests are added by palpate_add_module_tests, after all modules exist.
    TEST_DIRECTORY_NAME NONE
    CMAKE_DESTINATION "${PALPATE_VTK_CMAKE_DIR}"
    VERSION "${PROJECT_VERSION}"
    SOVERSION "${PALPATE_CXX_SOVERSION}"
    TARGET_NAMESPACE Palpate)
endmacro()

# Adds a VTK module: VTK classes (header and source pairs, wrapped and installed), kernel classes (private), and
# our compiler settings. Folders are header folders relative to the module's own.
#   palpate_add_vtk_module(Module CLASSES vtkA… KERNELS Sub/B… FOLDERS Sub…)
function(palpate_add_vtk_module module)
  cmake_parse_arguments(arg "" "" "CLASSES;KERNELS;FOLDERS" ${ARGN})
  vtk_module_add_module(Palpate::${module}
    CLASSES ${arg_CLASSES}
    PRIVATE_CLASSES ${arg_KERNELS}
    HEADERS_SUBDIR palpate)
  palpate_link_public_headers(${module} . "${arg_CLASSES}" unused)
  # A module may hold headers only.
  set_target_properties(${module} PROPERTIES LINKER_LANGUAGE CXX)
  palpate_compile_settings(${module})
  foreach(folder IN LISTS arg_FOLDERS)
    cmake_path(ABSOLUTE_PATH folder NORMALIZE)
    target_include_directories(${module} PUBLIC $<BUILD_INTERFACE:${folder}>)
  endforeach()
  if(arg_CLASSES)
    set_property(GLOBAL APPEND PROPERTY PALPATE_MODULES_WITH_VTK_CLASSES ${module})
  endif()
endfunction()

# Adds the library of a module without VTK, with its alias, settings, header folders (relative to the
# module's own), public headers and export.
#   palpate_add_kernel_module(Module SOURCES a.cxx… FOLDERS . Sub… LIBRARIES t…)
function(palpate_add_kernel_module module)
  cmake_parse_arguments(arg "" "" "SOURCES;FOLDERS;LIBRARIES" ${ARGN})
  add_library(${module} ${arg_SOURCES})
  add_library(Palpate::${module} ALIAS ${module})
  palpate_compile_settings(${module})
  # Smaller units than elsewhere, so that a changed kernel is compiled soon; in units of five the headers that
  # they share take half of the time.
  set_target_properties(${module} PROPERTIES
    OUTPUT_NAME Palpate${module} VERSION ${PROJECT_VERSION} SOVERSION ${PALPATE_CXX_SOVERSION}
    UNITY_BUILD_BATCH_SIZE 15)
  # A unit of many sources is inlined as freely as one source. Longer walks of aliases cost a third of the
  # time of unrolled kernels, and find nothing.
  target_compile_options(${module} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU>:--param=large-unit-insns=1000000;--param=sccvn-max-alias-queries-per-access=50>")
  target_compile_features(${module} PUBLIC cxx_std_17)
  foreach(folder IN LISTS arg_FOLDERS)
    cmake_path(ABSOLUTE_PATH folder NORMALIZE)
    target_include_directories(${module} PUBLIC $<BUILD_INTERFACE:${folder}>)
  endforeach()
  target_include_directories(${module} PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${module} PUBLIC ${arg_LIBRARIES})
  install(TARGETS ${module} EXPORT PalpateKernels
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT kernels NAMELINK_COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  palpate_link_public_headers(${module} "${arg_FOLDERS}" "" public)
  install(FILES ${public} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/palpate
    COMPONENT development)
endfunction()

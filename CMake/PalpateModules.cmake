# The VTK modules: scanned from their vtk.module files, built and installed by VTK's module system.

set(PALPATE_VTK_MODULE_FILES)
foreach(room IO Surface ShapeModel VolumeRendering Imaging Interaction Session)
  list(APPEND PALPATE_VTK_MODULE_FILES "${CMAKE_CURRENT_SOURCE_DIR}/Modules/${room}/vtk.module")
endforeach()
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
    HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/palpate"
    VERSION "${PROJECT_VERSION}"
    SOVERSION 1
    TARGET_NAMESPACE Palpate)
endmacro()

# Adds a VTK module: VTK classes (header and source pairs, wrapped), kernel classes (not wrapped), and
# our compiler settings.
#   palpate_add_vtk_module(Module CLASSES vtkA… KERNELS B… HEADERS C…)
function(palpate_add_vtk_module room)
  cmake_parse_arguments(arg "" "" "CLASSES;KERNELS;HEADERS" ${ARGN})
  list(TRANSFORM arg_HEADERS APPEND ".h")
  vtk_module_add_module(Palpate::${room}
    CLASSES ${arg_CLASSES}
    NOWRAP_CLASSES ${arg_KERNELS}
    NOWRAP_HEADERS ${arg_HEADERS})
  # A module may hold headers only.
  set_target_properties(${room} PROPERTIES LINKER_LANGUAGE CXX)
  palpate_compile_settings(${room})
  if(arg_CLASSES)
    set_property(GLOBAL APPEND PROPERTY PALPATE_ROOMS_WITH_VTK_CLASSES ${room})
  endif()
endfunction()

# Adds the library of a module without VTK, with its alias, settings, header folders (relative to the
# module's own), installed headers and export.
#   palpate_add_kernel_room(Module SOURCES a.cxx… HEADERS a.h… FOLDERS . Sub… LIBRARIES t…)
function(palpate_add_kernel_room room)
  cmake_parse_arguments(arg "" "" "SOURCES;HEADERS;FOLDERS;LIBRARIES" ${ARGN})
  add_library(${room} ${arg_SOURCES})
  add_library(Palpate::${room} ALIAS ${room})
  palpate_compile_settings(${room})
  set_target_properties(${room} PROPERTIES
    OUTPUT_NAME Palpate${room} VERSION ${PROJECT_VERSION} SOVERSION 1)
  target_compile_features(${room} PUBLIC cxx_std_17)
  foreach(folder IN LISTS arg_FOLDERS)
    cmake_path(ABSOLUTE_PATH folder NORMALIZE)
    target_include_directories(${room} PUBLIC $<BUILD_INTERFACE:${folder}>)
  endforeach()
  target_include_directories(${room} PUBLIC
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/palpate>)
  target_link_libraries(${room} PUBLIC ${arg_LIBRARIES})
  install(TARGETS ${room} EXPORT PalpateKernels
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(FILES ${arg_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/palpate)
endfunction()

# Tests: one GoogleTest program a room, named <Room>Tests, discovered one ctest entry a test.

find_package(GTest REQUIRED)
include(GoogleTest)
enable_testing()
find_program(PALPATE_XVFB_RUN xvfb-run)

# palpate_add_gtest(name SOURCES a.cxx… LIBRARIES t… [LABELS l…])
function(palpate_add_gtest name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  palpate_compile_settings(${name})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} Palpate::TestSupport GTest::gtest_main)
  vtk_module_autoinit(TARGETS ${name} MODULES VTK::RenderingOpenGL2 VTK::RenderingFreeType
    VTK::InteractionStyle)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_PREFIX "${name}." PROPERTIES TIMEOUT 300)
endfunction()

# Every room's Testing folder, after all rooms exist, so that a room's tests may use any lower room.
function(palpate_add_module_tests)
  add_subdirectory(Testing/Support)
  foreach(room Numerics IO Surface ShapeModel Session)
    add_subdirectory(Modules/${room}/Testing)
  endforeach()
endfunction()

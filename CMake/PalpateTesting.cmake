# Tests: one GoogleTest program per module, named <Module>Tests, with one ctest entry per test unless many
# share a process.

include(GoogleTest)
enable_testing()
# GNU's linker reads every library that a program's libraries need; these take a sixth of its time.
include(CheckLinkerFlag)
foreach(linker lld gold)
  check_linker_flag(CXX "-fuse-ld=${linker}" PALPATE_LINKS_WITH_${linker})
  if(PALPATE_LINKS_WITH_${linker})
    set(palpate_test_linker "-fuse-ld=${linker}")
    break()
  endif()
endforeach()
# A virtual USB bus for unchanged programs.
if(PkgConfig_FOUND AND TARGET PkgConfig::libusb)
  pkg_check_modules(umockdev IMPORTED_TARGET umockdev-1.0 gobject-2.0)
endif()

# palpate_add_gtest(name SOURCES a.cxx… LIBRARIES t… [RENDERING filter] [TOGETHER filter] [PROCESSES n]
#   [COMPUTES] [ON_VIRTUAL_BUS])
# RENDERING: GoogleTest's filter for the tests that render through OpenGL.
# PROCESSES: ctest runs the tests in so many processes, named <name>.Part1 and so on, each with every n-th test: where
# to start a process for each would take about as long as the test. With sanitizers each has its own.
# COMPUTES: the tests themselves take long, so that they are optimised. Others call libraries that are.
# TOGETHER: the filter for tests that share what takes long to make; ctest runs them in one process, named
# <name>.Together.
# ON_VIRTUAL_BUS: the tests see umockdev's devices, as under umockdev-wrapper.
function(palpate_add_gtest name)
  cmake_parse_arguments(arg "COMPUTES;ON_VIRTUAL_BUS" "RENDERING;TOGETHER;PROCESSES" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  # Only tests have namespaces of their own.
  set(helpers ${arg_SOURCES})
  list(FILTER helpers EXCLUDE REGEX "(^|/)Test[A-Za-z0-9]+[.]cxx$")
  set_source_files_properties(${helpers} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  palpate_compile_settings(${name})
  if(arg_COMPUTES)
    palpate_compile_sooner(${name})
  else()
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O0>)
  endif()
  target_link_options(${name} PRIVATE ${palpate_test_linker})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} Palpate::TestSupport GTest::gtest_main)
  if(PALPATE_USE_VTK)
    vtk_module_autoinit(TARGETS ${name} MODULES VTK::RenderingOpenGL2 VTK::RenderingFreeType
      VTK::InteractionStyle)
  endif()
  set(discover ${name} DISCOVERY_MODE PRE_TEST TEST_PREFIX "${name}.")
  set(others "-")
  if(arg_TOGETHER)
    add_test(NAME ${name}.Together COMMAND ${name} "--gtest_filter=${arg_TOGETHER}")
    # They take longest, so they start first.
    set_tests_properties(${name}.Together PROPERTIES TIMEOUT 900 COST 1000)
    string(APPEND others "${arg_TOGETHER}:")
  endif()
  if(arg_PROCESSES AND NOT PALPATE_SANITIZERS)
    math(EXPR last "${arg_PROCESSES} - 1")
    foreach(index RANGE ${last})
      math(EXPR part "${index} + 1")
      add_test(NAME ${name}.Part${part} COMMAND ${name})
      # They take long, so they start early.
      set_tests_properties(${name}.Part${part} PROPERTIES TIMEOUT 900 COST 90 ENVIRONMENT
        "GTEST_TOTAL_SHARDS=${arg_PROCESSES};GTEST_SHARD_INDEX=${index}")
    endforeach()
  elseif(arg_RENDERING)
    # Mesa leaks memory in libraries that it has unloaded, which no suppression can name.
    gtest_discover_tests(${discover} TEST_FILTER "${arg_RENDERING}"
      TEST_LIST ${name}_RENDERING_TESTS
      PROPERTIES TIMEOUT 300 ENVIRONMENT "ASAN_OPTIONS=detect_leaks=0")
    gtest_discover_tests(${discover} TEST_FILTER "${others}${arg_RENDERING}" PROPERTIES TIMEOUT 300)
  elseif(arg_ON_VIRTUAL_BUS)
    # In real time, with several processes per byte: one of them at a time, from the start, since they mostly wait.
    # AddressSanitizer would be the first library, and GLib keeps much memory until the end.
    gtest_discover_tests(${discover} PROPERTIES TIMEOUT 240 RESOURCE_LOCK virtual-bus COST 100 ENVIRONMENT
      "LD_PRELOAD=libumockdev-preload.so.0;ASAN_OPTIONS=verify_asan_link_order=0:detect_leaks=0")
  else()
    gtest_discover_tests(${discover} TEST_FILTER "${others}" PROPERTIES TIMEOUT 300)
  endif()
endfunction()

# palpate_add_study(name SOURCES a.cxx… LIBRARIES t…): a program that only a script of Utilities runs, for a page of
# Documentation/Evidence. It is built by name, and with the benchmarks.
function(palpate_add_study name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  palpate_compile_settings(${name})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
  if(NOT PALPATE_BUILD_BENCHMARKS)
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
endfunction()

# palpate_add_test_library(name SOURCES a.cxx… LIBRARIES t…): what several programs for tests share, compiled
# once.
function(palpate_add_test_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  palpate_compile_settings(${name})
  palpate_compile_sooner(${name})
  target_include_directories(${name} PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${name} PUBLIC ${arg_LIBRARIES} Palpate::TestSupport)
endfunction()

# Every module's Testing folder, after all modules exist, so that its tests may use any lower module.
function(palpate_add_module_tests)
  add_subdirectory(Testing/Support)
  add_subdirectory(Testing/References)
  add_subdirectory(Testing/VirtualFalcon)
  set(modules ${PALPATE_KERNEL_MODULES})
  foreach(module IN LISTS modules)
    add_subdirectory(Modules/${module}/Testing)
  endforeach()
  if(NOT PALPATE_USE_VTK)
    return()
  endif()
  foreach(module IO Filters VolumeRendering Display Interaction Report Fit Group Comparison Scene Task Trade Study)
    add_subdirectory(Modules/${module}/Testing)
  endforeach()
  if(PALPATE_HAS_QT)
    add_subdirectory(Modules/Widgets/Testing)
    add_subdirectory(Applications/Viewer/Testing)
  endif()
endfunction()

# Compiler settings for our own targets; not for generated code (Python wrappers).

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")

find_program(PALPATE_CCACHE ccache)
mark_as_advanced(PALPATE_CCACHE)
if(PALPATE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${PALPATE_CCACHE}")
endif()

# A library whose interface is unchanged needs no new link of what uses it.
set(CMAKE_LINK_DEPENDS_NO_SHARED ON)

# GCC collects its own garbage from 128 MB on, again and again: a tenth of the time of our larger sources.
add_compile_options("$<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=1000000>")

if(PALPATE_SANITIZERS)
  add_compile_options(-fsanitize=${PALPATE_SANITIZERS} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${PALPATE_SANITIZERS})
endif()

function(palpate_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wnon-virtual-dtor
    -Woverloaded-virtual -Wno-unused-parameter
    $<$<BOOL:${PALPATE_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

# Warnings for one of our targets; a library with an undefined symbol fails at link time, not at load
# time. No code reads errno after a square root, and no code interposes library functions: both would
# prevent inlining. Neither changes a result. Products and sums are fused only by kernels that ask for it:
# elsewhere, a product that is rounded once and its equal that is rounded twice would decide differently, on arm64.
function(palpate_compile_settings target)
  # Clang links its sanitizers into programs only, so libraries have undefined symbols until then.
  if(NOT (PALPATE_SANITIZERS AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang"))
    target_link_options(${target} PRIVATE -Wl,--no-undefined)
  endif()
  target_compile_options(${target} PRIVATE -fno-math-errno -fno-semantic-interposition -ffp-contract=off)
  palpate_warnings(${target})
endfunction()

# For a target that only calls our libraries, where its time is spent: compiled sooner, with fewer
# optimisations.
function(palpate_compile_sooner target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Writes what Qt needs of a target's classes with signals and slots, and compiles it as one source. moc writes nothing for other
# classes. It gets no include folders, unlike by AUTOMOC: with them it reads VTK's headers too, takes a hundred times as long, and
# writes the same.
function(palpate_add_meta_objects target)
  get_target_property(headers ${target} SOURCES)
  list(TRANSFORM headers REPLACE "[.]cxx$" ".h")
  qt_wrap_cpp(written ${headers} OPTIONS --no-notes)
  set_source_files_properties(${written} PROPERTIES HEADER_FILE_ONLY ON)
  list(JOIN written "\"\n#include \"" includes)
  set(all "${CMAKE_CURRENT_BINARY_DIR}/${target}MetaObjects.cxx")
  file(CONFIGURE OUTPUT "${all}" CONTENT "#include \"${includes}\"\n")
  target_sources(${target} PRIVATE ${written} "${all}")
endfunction()

# What `palpate` says of itself, for manual pages, shells and 3D Slicer: made after the build.

set(made "${CMAKE_BINARY_DIR}/share/palpate")
# palpate_describe(file arguments…): a file with what the program prints.
function(palpate_describe file)
  add_custom_command(OUTPUT "${made}/${file}"
    COMMAND ${CMAKE_COMMAND} -E make_directory "${made}"
    COMMAND palpate ${ARGN} > "${made}/${file}"
    DEPENDS palpate VERBATIM)
  set_property(GLOBAL APPEND PROPERTY PALPATE_DESCRIPTIONS "${made}/${file}")
endfunction()
palpate_describe(palpate.1 manual)
palpate_describe(palpate.bash completion bash)
palpate_describe(_palpate completion zsh)
palpate_describe(palpate.fish completion fish)
get_property(descriptions GLOBAL PROPERTY PALPATE_DESCRIPTIONS)
add_custom_target(palpate-descriptions ALL DEPENDS ${descriptions})
# Nothing is installed of these, and what a sanitizer finds belongs into tests.
if(PALPATE_SANITIZERS)
  set_target_properties(palpate-descriptions PROPERTIES EXCLUDE_FROM_ALL ON)
endif()

install(FILES "${made}/palpate.1" DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
# The page is that of the helpers, too.
foreach(helper palpate-dicom-decoder palpate-falcon-guard palpate-transform-hdf5)
  if(TARGET ${helper})
    file(WRITE "${made}/${helper}.1" ".so man1/palpate.1\n")
    install(FILES "${made}/${helper}.1" DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  endif()
endforeach()
install(FILES "${made}/palpate.bash" RENAME palpate
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES "${made}/_palpate" DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES "${made}/palpate.fish" DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# Slicer starts one program a module: a launcher for every command that writes files (a test compares).
# The folder is lib/palpate/slicer-cli of the build tree and of what is installed.
set(launchers "${CMAKE_BINARY_DIR}/lib/palpate/slicer-cli")
foreach(command check cohort compare complete convert correct fit measure mesh phantom register relate render soften study task touch tradeoff)
  string(SUBSTRING ${command} 0 1 initial)
  string(SUBSTRING ${command} 1 -1 rest)
  string(TOUPPER ${initial} initial)
  configure_file(Describe/SlicerLauncher.sh.in "${launchers}/Palpate${initial}${rest}" @ONLY
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endforeach()
install(DIRECTORY "${launchers}/" DESTINATION lib/palpate/slicer-cli USE_SOURCE_PERMISSIONS)

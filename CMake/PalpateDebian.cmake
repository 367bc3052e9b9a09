# Runs in CPack before a .deb is made of each component: no run paths, since /usr/lib is searched
# anyway; copyright, changelog and reasons for what lintian reports.

set(source "${CMAKE_CURRENT_LIST_DIR}/..")
file(READ "${source}/LICENSE" license)
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(REGEX REPLACE "\n" "\n " license " ${license}")
string(STRIP "${license}" license)
set(license " ${license}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

foreach(component kernels runtime viewer development python filters)
  string(TOUPPER ${component} upper)
  set(package "${CPACK_DEBIAN_${upper}_PACKAGE_NAME}")
  set(root "${CPACK_TEMPORARY_DIRECTORY}/${component}/usr")
  if(NOT IS_DIRECTORY "${root}")
    continue()
  endif()
  file(GLOB_RECURSE files LIST_DIRECTORIES OFF "${root}/bin/*" "${root}/lib/*.so*")
  foreach(file IN LISTS files)
    if(NOT IS_SYMLINK "${file}")
      file(RPATH_REMOVE FILE "${file}")
    endif()
  endforeach()
  set(documents "${root}/share/doc/${package}")
  file(REMOVE_RECURSE "${root}/share/doc")
  configure_file("${source}/Packaging/copyright.in" "${documents}/copyright" @ONLY
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  file(WRITE "${documents}/changelog" "palpate (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * See CHANGELOG.md of the sources.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  file(GLOB compressible "${documents}/changelog" "${root}/share/man/man1/*.1")
  execute_process(COMMAND gzip -9nf ${compressible} COMMAND_ERROR_IS_FATAL ANY)
  if(EXISTS "${source}/Packaging/${package}.lintian-overrides")
    file(COPY_FILE "${source}/Packaging/${package}.lintian-overrides" "${documents}/overrides")
    file(MAKE_DIRECTORY "${root}/share/lintian/overrides")
    file(RENAME "${documents}/overrides" "${root}/share/lintian/overrides/${package}")
  endif()
endforeach()

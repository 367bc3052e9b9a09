# The Python package `palpate`: the VTK classes of the modules, wrapped by VTK's tools.
# It works from the build tree (PYTHONPATH=build/…/lib/python3/dist-packages) and installed.

set(PALPATE_PYTHON_DIR "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages")

# A module without a VTK class has nothing to wrap.
get_property(wrapped_names GLOBAL PROPERTY PALPATE_MODULES_WITH_VTK_CLASSES)
set(wrapped_modules ${wrapped_names})
list(TRANSFORM wrapped_modules PREPEND "Palpate::")
vtk_module_wrap_python(
  MODULES ${wrapped_modules}
  PYTHON_PACKAGE palpate
  MODULE_DESTINATION "${PALPATE_PYTHON_DIR}"
  CMAKE_DESTINATION "${PALPATE_VTK_CMAKE_DIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  INSTALL_EXPORT PalpateModules
  TARGET Palpate::Python)

set(PALPATE_PYTHON_IMPORTS)
foreach(module IN LISTS wrapped_names)
  string(APPEND PALPATE_PYTHON_IMPORTS "from .Palpate${module} import *\n")
endforeach()
set(init "${CMAKE_BINARY_DIR}/${PALPATE_PYTHON_DIR}/palpate/__init__.py")
configure_file(Python/palpate/__init__.py.in "${init}" @ONLY)
install(FILES "${init}" DESTINATION "${PALPATE_PYTHON_DIR}/palpate" COMPONENT python)

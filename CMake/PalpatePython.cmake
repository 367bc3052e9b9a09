# The Python package `palpate`: the interface for C over NumPy arrays, and the VTK classes of the
# modules, wrapped by VTK's tools, which are loaded on demand.
# It works from the build tree (PYTHONPATH=build/…/lib/python3/dist-packages) and installed.

set(PALPATE_PYTHON_DIR "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages" CACHE STRING
  "Folder of the Python package, below the prefix")
mark_as_advanced(PALPATE_PYTHON_DIR)

add_subdirectory(Modules/PythonInterface)
set(palpate_package "${PALPATE_PYTHON_DIR}/palpate")
foreach(file __init__.py _correct.py _inputs.py _results.py pyvista.py _kernels.pyi py.typed)
  configure_file(Python/palpate/${file} "${CMAKE_BINARY_DIR}/${palpate_package}/${file}" COPYONLY)
  install(FILES Python/palpate/${file} DESTINATION "${palpate_package}" COMPONENT python)
endforeach()

if(PALPATE_USE_VTK)
  # A module without a VTK class has nothing to wrap.
  get_property(wrapped_modules GLOBAL PROPERTY PALPATE_MODULES_WITH_VTK_CLASSES)
  list(TRANSFORM wrapped_modules PREPEND "Palpate::")
  vtk_module_wrap_python(
    MODULES ${wrapped_modules}
    PYTHON_PACKAGE palpate
    MODULE_DESTINATION "${PALPATE_PYTHON_DIR}"
    CMAKE_DESTINATION "${PALPATE_VTK_CMAKE_DIR}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    INSTALL_EXPORT PalpateModules
    COMPONENT filters
    TARGET Palpate::Python)
endif()

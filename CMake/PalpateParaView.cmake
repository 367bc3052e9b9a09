# A build of the plugin for ParaView alone. ParaView has a VTK of its own, and two VTKs in one process fail, so programs,
# window, Python package and tests, which use the system's, belong to another build tree.

# Targets of ParaView's VTK name Python's.
find_package(Python3 REQUIRED COMPONENTS Development)
find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingViews)
# Where ParaView has found its VTK; PalpateDependencies looks there too.
set(VTK_DIR "${ParaView_DIR}/vtk")
foreach(option PALPATE_WRAP_PYTHON PALPATE_BUILD_BENCHMARKS PALPATE_BUILD_VIEWER BUILD_TESTING)
  set(${option} OFF)
endforeach()
set(PALPATE_USE_VTK ON)

# Every package that the build uses; Documentation/Architecture.md gives the reasons.

# Asked for 3.4, CMake refuses Eigen 5.
find_package(Eigen3 REQUIRED NO_MODULE)
if(Eigen3_VERSION VERSION_LESS 3.4)
  message(FATAL_ERROR "Eigen ${Eigen3_VERSION} was found; Palpate needs 3.4 or newer")
endif()
find_package(nlohmann_json 3.11 REQUIRED)
find_package(Threads REQUIRED)
find_package(BLAS REQUIRED)
# Headers of Boost.Math.
find_package(Boost REQUIRED)

# Without libusb everything is built except the access to a real Falcon.
find_package(PkgConfig)
if(PkgConfig_FOUND)
  pkg_check_modules(libusb IMPORTED_TARGET libusb-1.0>=1.0.23)
endif()
if(NOT TARGET PkgConfig::libusb)
  message(STATUS "libusb (libusb-1.0-0-dev) was not found: there will be no device named falcon")
endif()

find_package(OpenIGTLink QUIET)
if(NOT OpenIGTLink_FOUND)
  message(STATUS "OpenIGTLink (libopenigtlink-dev) was not found: no device of that name, no palpate link")
endif()

# Without pybind11 everything is built except the Python package.
set(PALPATE_HAS_PYTHON OFF)
if(PALPATE_WRAP_PYTHON)
  if(PALPATE_USE_VTK)
    # Debian's VTK package is built for the system's interpreter, whatever else is on the PATH.
    set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "")
  endif()
  find_package(Python3 3.9 COMPONENTS Interpreter Development.Module)
  set(PYBIND11_FINDPYTHON ON)
  find_package(pybind11 2.10 CONFIG QUIET)
  if(Python3_FOUND AND pybind11_FOUND)
    set(PALPATE_HAS_PYTHON ON)
  else()
    message(STATUS "The Python package is left out: it needs pybind11-dev and python3-dev")
  endif()
endif()

set(PALPATE_HAS_QT OFF)
if(NOT PALPATE_USE_VTK)
  return()
endif()

# Components are listed explicitly: otherwise VTK requires every third-party package and pulls in
# the MPI modules, which replace standard classes.
set(PALPATE_VTK_COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonMisc CommonTransforms
  FiltersCore FiltersGeneral FiltersGeometry FiltersModeling FiltersSources
  ImagingCore ImagingGeneral ImagingMorphological ImagingStencil
  IOCore IOExport IOGeometry IOImage IOPLY IOXML
  InteractionStyle RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2
  RenderingVolume RenderingVolumeOpenGL2)
set(palpate_vtk_build_components IOLegacy TestingCore TestingRendering RenderingImage)
if(PALPATE_BUILD_PARAVIEW)
  # Modules that ParaView's VTK lacks, and the plugin does not use.
  list(REMOVE_ITEM PALPATE_VTK_COMPONENTS ImagingMorphological ImagingStencil)
  set(palpate_vtk_build_components)
endif()
if(PALPATE_HAS_PYTHON)
  list(APPEND palpate_vtk_build_components WrappingPythonCore CommonPython WrappingTools Python)
endif()
if(PALPATE_BUILD_VIEWER)
  set(palpate_vtk_qt_components GUISupportQt)
endif()
find_package(VTK 9.1 REQUIRED COMPONENTS ${PALPATE_VTK_COMPONENTS} ${palpate_vtk_build_components}
  OPTIONAL_COMPONENTS ${palpate_vtk_qt_components})
# The Qt that VTK was built with.
if(TARGET VTK::GUISupportQt AND TARGET Qt6::Widgets)
  set(PALPATE_QT Qt6)
  set(PALPATE_HAS_QT ON)
elseif(TARGET VTK::GUISupportQt AND TARGET Qt5::Widgets AND Qt5Widgets_VERSION VERSION_GREATER_EQUAL 5.15)
  set(PALPATE_QT Qt5)
  set(PALPATE_HAS_QT ON)
elseif(PALPATE_BUILD_VIEWER)
  message(STATUS "palpate-viewer is left out: it needs Qt 5.15 or 6 and VTK's libvtk9-qt-dev")
else()
  message(STATUS "palpate-viewer is left out, as PALPATE_BUILD_VIEWER says")
endif()

find_package(ITK 5.2 REQUIRED COMPONENTS ITKCommon ITKIOImageBase ITKIONIFTI ITKIONRRD ITKIOMeta
  ITKTransform ITKIOTransformBase ITKIOTransformInsightLegacy
  ITKMetricsv4 ITKOptimizersv4 ITKRegistrationMethodsv4
  ITKImageLabel ITKConnectedComponents ITKLabelMap ITKImageFunction)
find_package(DCMTK REQUIRED)
# Debian packages OpenJPEG's programs separately from its library, and CMake reports each as absent.
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
find_package(OpenJPEG REQUIRED NO_MODULE)
unset(CMAKE_MESSAGE_LOG_LEVEL)
find_package(ZLIB REQUIRED)
find_package(X11 REQUIRED)
if(NOT PALPATE_BUILD_PARAVIEW)
  find_package(CLI11 REQUIRED)
endif()

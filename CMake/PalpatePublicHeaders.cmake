# What programs of others may include, as <palpate/NAME.h>: these and the VTK classes; and <palpate.h>, the C library.
# They are at most 100, and include no other header of ours, which a test checks. All other headers stay here.
set(PALPATE_PUBLIC_HEADERS
  BodyComparison BodyOverlap BrickDirectory BrickLayout BrickedChannel CacheLineVector CellSet
  CoefficientCovariance ComparedBody Contact ContactModel ContactTracker DeviceCapabilities DeviceSample
  DeviceState DirectionCoverage DistanceSamples ElasticContactModel EvaluationKernel FieldContactModel FieldGrid
  FieldHit FieldMaterial FieldSampler FieldSolid HapticDevice IndexToWorld IndexedMesh InstructionSet
  KernelProgress LargestEmptyCap MaskModel MaskShape MaskSurface MaterialMap ModelDocument ModelFile
  ModelMeasures NearestOnMesh OrganContact OrganModel PackedTriangle PlainVector3 RadialEvaluator
  RadialModel RadialModelFit RadialSamples RayCaster ScalarField ScalarType ShapeAlignment ShapeField ShapeModes
  SideBias SphericalHarmonicBasis SphericalHarmonicRecurrence SphericalPlacement SphericalTriangle Status
  SurfaceCurvature SurfaceEvaluator SurfaceFriction SurfaceModel SurfaceModelFit ToolPose
  ToolShape ToolSkeleton TopologyReport TriangleKernel TriangleTree Vector3 VoxelMask WindingNumbers)

# The folder of <palpate/NAME.h> for programs that use a build tree.
set(PALPATE_BUILD_INCLUDE_DIR "${CMAKE_BINARY_DIR}/include")
file(REMOVE_RECURSE "${PALPATE_BUILD_INCLUDE_DIR}")
file(MAKE_DIRECTORY "${PALPATE_BUILD_INCLUDE_DIR}/palpate")

# Links the public headers of a module's folders, and those of its VTK classes, into that folder, and lists them.
function(palpate_link_public_headers module folders classes result)
  set(found)
  foreach(folder IN LISTS folders)
    foreach(name IN LISTS PALPATE_PUBLIC_HEADERS classes)
      set(header "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${name}.h")
      if(EXISTS "${header}")
        list(APPEND found "${header}")
        file(CREATE_LINK "${header}" "${PALPATE_BUILD_INCLUDE_DIR}/palpate/${name}.h" SYMBOLIC)
      endif()
    endforeach()
  endforeach()
  target_include_directories(${module} PUBLIC $<BUILD_INTERFACE:${PALPATE_BUILD_INCLUDE_DIR}>)
  set(${result} "${found}" PARENT_SCOPE)
endfunction()

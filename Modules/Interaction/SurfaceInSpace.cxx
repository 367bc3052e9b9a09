#include "SurfaceInSpace.h"

#include "ArrayColors.h"
#include "SurfaceMaterial.h"
#include "SurfaceNormals.h"
#include "Vector3.h"
#include "vtkProbeRepresentation.h"
#include "vtkSurfaceDisplay.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"

#include <algorithm>

namespace palpate
{
namespace
{
// Positions are the camera's, as those of fragments; nothing is touched where the radius is 0.
constexpr const char* ContactShader = R"(//VTK::Color::Impl
  if (contactRadius > 0.0)
  {
    float contactShare = 1.0 - smoothstep(0.5 * contactRadius, contactRadius,
      distance(vertexVC.xyz, contactPlace));
    diffuseColor = mix(diffuseColor, contactDiffuse, contactShare);
    ambientColor = mix(ambientColor, contactAmbient, contactShare);
  }
)";

// The tool's point that touches: from its middle against the force on the hand.
Vector3 ContactPlace(vtkProbeRepresentation* probe)
{
  vtkMatrix4x4* place = probe->GetProxyMatrix();
  const Vector3 middle(place->GetElement(0, 3), place->GetElement(1, 3), place->GetElement(2, 3));
  const Vector3 force(probe->GetForce());
  return force.norm() > 0.0 ? Vector3(middle - probe->GetToolRadius() * force.normalized())
                            : middle;
}
} // namespace

SurfaceInSpace::SurfaceInSpace(vtkSurfaceDisplay* display) : Shown(display)
{
  this->Surface->SetMapper(this->Mapper);
  vtkProperty* property = this->Surface->GetProperty();
  property->SetAmbient(SurfaceMaterial::Ambient);
  property->SetDiffuse(SurfaceMaterial::Diffuse);
  property->SetSpecular(SurfaceMaterial::Specular);
  property->SetSpecularPower(SurfaceMaterial::SpecularPower);
  this->Surface->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Color::Impl", true,
                                                                   ContactShader, false);
  this->UpdateContact(nullptr, nullptr);
}

SurfaceInSpace::~SurfaceInSpace() = default;

void SurfaceInSpace::Update()
{
  const bool isShown = this->Shown->GetVisibility() && this->Shown->GetSurface() != nullptr;
  this->Surface->SetVisibility(isShown ? 1 : 0);
  const std::uint64_t time = this->Shown->GetMTime();
  if (!isShown || time == this->Time)
  {
    return;
  }
  this->Time = time;
  this->Mapper->SetInputData(WithNormals(this->Shown->GetSurface()));
  this->Surface->GetProperty()->SetColor(this->Shown->GetColor());
  this->Surface->GetProperty()->SetOpacity(this->Shown->GetOpacity());
  this->ColorByArray();
}

void SurfaceInSpace::ColorByArray()
{
  const char* name = this->Shown->GetColorArray();
  vtkDataArray* values = this->Mapper->GetInput()->GetPointData()->GetArray(name);
  const bool isColored = values != nullptr && values->GetNumberOfComponents() == 1;
  this->Mapper->SetScalarVisibility(isColored ? 1 : 0);
  this->Lookup = nullptr;
  if (isColored)
  {
    double range[2];
    values->GetFiniteRange(range);
    this->Lookup = MakeArrayColors(range[0], range[1]);
    this->Mapper->SetScalarModeToUsePointFieldData();
    this->Mapper->SelectColorArray(name);
    this->Mapper->SetLookupTable(this->Lookup);
    this->Mapper->UseLookupTableScalarRangeOn();
    this->Mapper->InterpolateScalarsBeforeMappingOn();
  }
}

void SurfaceInSpace::UpdateContact(vtkProbeRepresentation* probe, vtkCamera* camera)
{
  const bool isTouched =
      probe != nullptr && probe->GetVisibility() && probe->GetInContact() && camera != nullptr;
  float place[3] = {0.0F, 0.0F, 0.0F};
  float diffuse[3] = {0.0F, 0.0F, 0.0F};
  float ambient[3] = {0.0F, 0.0F, 0.0F};
  if (isTouched)
  {
    const Vector3 world = ContactPlace(probe);
    const double point[4] = {world.x(), world.y(), world.z(), 1.0};
    double seen[4];
    camera->GetViewTransformMatrix()->MultiplyPoint(point, seen);
    for (int part = 0; part < 3; ++part)
    {
      const double color = probe->GetContactColor()[part];
      place[part] = static_cast<float>(seen[part]);
      diffuse[part] = static_cast<float>(SurfaceMaterial::Diffuse * color);
      ambient[part] = static_cast<float>(SurfaceMaterial::Ambient * color);
    }
  }
  vtkUniforms* uniforms = this->Surface->GetShaderProperty()->GetFragmentCustomUniforms();
  uniforms->SetUniformf("contactRadius",
                        isTouched ? static_cast<float>(probe->GetContactRadius()) : 0.0F);
  uniforms->SetUniform3f("contactPlace", place);
  uniforms->SetUniform3f("contactDiffuse", diffuse);
  uniforms->SetUniform3f("contactAmbient", ambient);
}
} // namespace palpate

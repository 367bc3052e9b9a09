#include "SurfaceInSpace.h"

#include "ContactMark.h"
#include "SurfaceMaterial.h"
#include "SurfaceNormals.h"
#include "ToolShadow.h"
#include "ViewColors.h"
#include "vtkSurfaceDisplay.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
// ContactMark::ShareAt. Positions are in camera coordinates, like those of fragments.
constexpr const char* ContactShader = R"(//VTK::Color::Impl
  float contactShare = 0.0;
  if (contactRadius > 0.0)
  {
    contactShare = contactStrength * (1.0 - smoothstep(0.5 * contactRadius, contactRadius,
      distance(vertexVC.xyz, contactPlace)));
    diffuseColor = mix(diffuseColor, contactDiffuse, contactShare);
    ambientColor = mix(ambientColor, contactAmbient, contactShare);
  }
)";

constexpr double SelectionWidth = 2.0; // points
constexpr double EdgeShare = 0.8;      // of full opacity, at the rim of a translucent surface

// After the normal is known and before the lights. ToolShadow::ShareAt; the contact keeps its
// colour. What a background takes from the light of a translucent surface is given back as far as
// nothing burns out.
constexpr const char* LightShader = R"(if (edgeShare > 0.0)
  {
    float edge = 1.0 - abs(dot(normalVCVSOutput, normalize(-vertexVC.xyz)));
    float clear = 1.0 - opacity;
    float most = max(max(diffuseColor.r, diffuseColor.g), diffuseColor.b) +
      max(max(ambientColor.r, ambientColor.g), ambientColor.b);
    float light = min(1.0 + clear, 0.92 / max(most, 0.4));
    diffuseColor *= light;
    ambientColor *= light;
    opacity = mix(opacity, 1.0, edgeShare * edge * edge);
  }
  if (shadowRadius > 0.0)
  {
    vec3 shadowPath = shadowCenter - vertexVC.xyz;
    float shadowDistance = max(length(shadowPath), shadowRadius);
    float shadowShare = (1.0 - contactShare) * shadowRadius * shadowRadius *
      clamp(dot(normalVCVSOutput, shadowPath) / shadowDistance, 0.0, 1.0) /
      (shadowDistance * shadowDistance);
    diffuseColor *= 1.0 - shadowShare;
    ambientColor *= 1.0 - shadowShare;
    specularColor *= 1.0 - shadowShare;
  }
  //VTK::Light::Impl
)";

std::array<float, 3> InCamera(const Vector3& world, vtkCamera* camera)
{
  const double point[4] = {world.x(), world.y(), world.z(), 1.0};
  double seen[4];
  camera->GetViewTransformMatrix()->MultiplyPoint(point, seen);
  return {{static_cast<float>(seen[0]), static_cast<float>(seen[1]), static_cast<float>(seen[2])}};
}
} // namespace

SurfaceInSpace::SurfaceInSpace(vtkSurfaceDisplay* display) : Shown(display)
{
  this->Surface->SetMapper(this->Mapper);
  SurfaceMaterial::Set(this->Surface->GetProperty());
  this->Surface->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Color::Impl", true,
                                                                   ContactShader, false);
  this->Surface->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                                                   LightShader, false);
  this->Add(this->Surface);
  this->Add(this->Outline);
  this->UpdateContact({}, nullptr);
  this->UpdateShadow({}, nullptr);
}

void SurfaceInSpace::Update()
{
  const bool isThere = this->Shown->GetSurface() != nullptr;
  const bool isShown = isThere && this->Shown->GetVisibility();
  this->Surface->SetVisibility(isShown ? 1 : 0);
  const std::uint64_t time = this->Shown->GetMTime();
  if (!isShown && !(isThere && this->Shown->GetForbidden()))
  {
    this->Time = 0;
    this->Range.reset();
    return;
  }
  if (time == this->Time)
  {
    return;
  }
  this->Time = time;
  this->Mapper->SetInputData(WithNormals(this->Shown->GetSurface()));
  const bool isWireframe = this->Shown->GetWireframe();
  this->Surface->SetPickable(isWireframe || !this->Shown->GetPickable() ? 0 : 1);
  this->Surface->GetProperty()->SetRepresentation(isWireframe ? VTK_WIREFRAME : VTK_SURFACE);
  this->SetMaterial();
  this->ColorByArray();
  if (!isShown)
  {
    this->Range.reset();
  }
}

void SurfaceInSpace::SetMaterial()
{
  constexpr double Evenness = 0.6; // how much light that has no direction a clear surface gets
  const double opacity = this->Shown->GetOpacity();
  const bool isTranslucent = opacity > 0.0 && opacity < 1.0;
  const bool isWireframe = this->Shown->GetWireframe();
  const double even = isTranslucent ? Evenness * (1.0 - opacity) * SurfaceMaterial::Diffuse : 0.0;
  vtkProperty* property = this->Surface->GetProperty();
  // Edges look unlit. Without VTK's lighting the contact's shader would have no positions.
  property->SetAmbient(isWireframe ? 1.0 : SurfaceMaterial::Ambient + even);
  property->SetDiffuse(isWireframe ? 0.0 : SurfaceMaterial::Diffuse - even);
  property->SetSpecular(isWireframe ? 0.0 : SurfaceMaterial::Specular);
  property->SetColor(this->Shown->GetColor());
  property->SetOpacity(opacity);
  // Through a translucent surface one sees what lies in it, not its far side.
  property->SetBackfaceCulling(opacity < 1.0);
  this->Surface->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf(
      "edgeShare", isTranslucent && !isWireframe ? static_cast<float>(EdgeShare) : 0.0F);
}

void SurfaceInSpace::UpdateOutline(bool isGroundLight, double pixels)
{
  const bool isForbidden = this->Shown->GetForbidden();
  const bool isSelected = this->Shown->GetHighlight() && this->Shown->GetVisibility() &&
                          this->Shown->GetOpacity() > 0.0;
  if (this->Shown->GetSurface() == nullptr || !(isForbidden || isSelected))
  {
    this->Outline.Update(nullptr, ForbiddenColor, 0.0, false);
    return;
  }
  const double grey = isGroundLight ? 0.1 : 1.0;
  this->Outline.Update(this->Mapper->GetInput(),
                       isForbidden ? ForbiddenColor : std::array<double, 3>{{grey, grey, grey}},
                       (isForbidden && isSelected ? 1.6 : 1.0) * SelectionWidth * pixels,
                       isForbidden);
}

void SurfaceInSpace::ColorByArray()
{
  const char* name = this->Shown->GetColorArray();
  vtkDataArray* values = this->Mapper->GetInput()->GetPointData()->GetArray(name);
  const bool isColored = values != nullptr && values->GetNumberOfComponents() == 1;
  this->Mapper->SetScalarVisibility(isColored ? 1 : 0);
  this->Range.reset();
  if (isColored)
  {
    std::array<double, 2> range{};
    values->GetFiniteRange(range.data());
    const double limit = this->Shown->GetColorLimit();
    this->Range = limit > 0.0 ? std::array<double, 2>{{-limit, limit}} : range;
    this->Mapper->SetScalarModeToUsePointFieldData();
    this->Mapper->SelectColorArray(name);
    this->Mapper->UseLookupTableScalarRangeOn();
    this->Mapper->InterpolateScalarsBeforeMappingOn();
  }
}

void SurfaceInSpace::SetColors(vtkLookupTable* colors)
{
  if (this->Mapper->GetLookupTable() != colors)
  {
    this->Mapper->SetLookupTable(colors);
  }
}

void SurfaceInSpace::UpdateContact(const ContactMark& contact, vtkCamera* camera)
{
  const bool isSeen = contact.IsSeen() && camera != nullptr;
  std::array<float, 3> place{};
  float diffuse[3] = {0.0F, 0.0F, 0.0F};
  float ambient[3] = {0.0F, 0.0F, 0.0F};
  if (isSeen)
  {
    place = InCamera(contact.PlaceWorld, camera);
    for (int part = 0; part < 3; ++part)
    {
      diffuse[part] = static_cast<float>(SurfaceMaterial::Diffuse * contact.Color[part]);
      ambient[part] = static_cast<float>(SurfaceMaterial::Ambient * contact.Color[part]);
    }
  }
  vtkUniforms* uniforms = this->Surface->GetShaderProperty()->GetFragmentCustomUniforms();
  uniforms->SetUniformf("contactRadius", isSeen ? static_cast<float>(contact.Radius) : 0.0F);
  uniforms->SetUniformf("contactStrength", static_cast<float>(contact.Strength));
  uniforms->SetUniform3f("contactPlace", place.data());
  uniforms->SetUniform3f("contactDiffuse", diffuse);
  uniforms->SetUniform3f("contactAmbient", ambient);
}

void SurfaceInSpace::UpdateShadow(const ToolShadow& shadow, vtkCamera* camera)
{
  const bool isSeen = shadow.IsSeen() && camera != nullptr && !this->Shown->GetWireframe();
  const std::array<float, 3> center =
      isSeen ? InCamera(shadow.CenterWorld, camera) : std::array<float, 3>{};
  vtkUniforms* uniforms = this->Surface->GetShaderProperty()->GetFragmentCustomUniforms();
  uniforms->SetUniformf("shadowRadius", isSeen ? static_cast<float>(shadow.Radius) : 0.0F);
  uniforms->SetUniform3f("shadowCenter", center.data());
}
} // namespace palpate

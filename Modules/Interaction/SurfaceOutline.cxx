#include "SurfaceOutline.h"

#include "ActorShaders.h"

#include "vtkPolyData.h"
#include "vtkUniforms.h"

namespace palpate
{
namespace
{
constexpr double OutlineGhostOpacity = 0.35;

// The normal's share towards the viewer is 0 at a silhouette, and its change from pixel to pixel
// tells how far away that is: on round surfaces half of their quotient, in pixels. On coarse meshes
// the share may miss 0.
constexpr const char* OutlineShader = R"(float outlineFacing =
    abs(dot(normalVCVSOutput, normalize(-vertexVC.xyz)));
  if (outlineFacing > max(1.6 * outlineWidth * fwidth(outlineFacing), 0.05))
  {
    discard;
  }
  //VTK::Light::Impl
)";

// The outline lies in its surface, and has to be seen.
constexpr const char* NearerShader = R"(//VTK::PositionVC::Impl
  gl_Position.z -= 0.0005 * gl_Position.w;
)";
} // namespace

SurfaceOutline::SurfaceOutline()
{
  this->Make(this->Line);
  this->Make(this->Ghost);
  this->Line.Actor->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
                                                                    NearerShader, false);
  ShowThrough(this->Ghost.Actor, OutlineGhostOpacity);
}

void SurfaceOutline::Make(Drawn& drawn)
{
  drawn.Mapper->ScalarVisibilityOff();
  drawn.Actor->SetMapper(drawn.Mapper);
  drawn.Actor->PickableOff();
  drawn.Actor->VisibilityOff();
  // Looks unlit. Without VTK's lighting the shader would have no normals.
  drawn.Actor->GetProperty()->SetAmbient(1.0);
  drawn.Actor->GetProperty()->SetDiffuse(0.0);
  drawn.Actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                                                 OutlineShader, false);
  drawn.Actor->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf("outlineWidth", 1.0F);
  this->Add(drawn.Actor);
}

void SurfaceOutline::Update(vtkPolyData* surface, const std::array<double, 3>& color, double width,
                            bool isSeenThrough)
{
  for (Drawn* drawn : {&this->Line, &this->Ghost})
  {
    const bool isShown = surface != nullptr && (drawn == &this->Line || isSeenThrough);
    drawn->Actor->SetVisibility(isShown ? 1 : 0);
    if (isShown)
    {
      drawn->Mapper->SetInputData(surface);
      drawn->Actor->GetProperty()->SetColor(color[0], color[1], color[2]);
      drawn->Actor->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf(
          "outlineWidth", static_cast<float>(width));
    }
  }
}
} // namespace palpate

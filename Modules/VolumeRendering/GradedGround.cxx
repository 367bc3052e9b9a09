#include "GradedGround.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#if __has_include("vtk_glad.h") // from VTK 9.4 on
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

namespace palpate
{
namespace
{
// The second output is a position, where ambient occlusion is drawn: too far away to hide anything.
constexpr const char* GroundShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform vec3 bottom;
uniform vec3 top;
  void main() {
  gl_FragData[0] = vec4(mix(bottom, top, texCoord.y), 1.0);
  gl_FragData[1] = vec4(0.0, 0.0, -1e6, 1.0);
  gl_FragData[2] = vec4(0.0, 0.0, 1.0, 1.0);
  gl_FragDepth = 1.0;
}
)";
} // namespace

vtkStandardNewMacro(GradedGround);

GradedGround::GradedGround() = default;
GradedGround::~GradedGround() = default;

int GradedGround::RenderOpaqueGeometry(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (window == nullptr)
  {
    return 0;
  }
  if (this->Quad == nullptr)
  {
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, GroundShader, "");
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglDepthFunc function(state);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  float bottom[3];
  float top[3];
  for (int part = 0; part < 3; ++part)
  {
    bottom[part] = static_cast<float>(renderer->GetBackground()[part]);
    top[part] = static_cast<float>(renderer->GetBackground2()[part]);
  }
  this->Quad->Program->SetUniform3f("bottom", bottom);
  this->Quad->Program->SetUniform3f("top", top);
  this->Quad->Render();
  return 1;
}

void GradedGround::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Quad != nullptr)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
} // namespace palpate

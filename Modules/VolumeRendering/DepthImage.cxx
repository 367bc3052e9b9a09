#include "DepthImage.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#if __has_include("vtk_glad.h") // from VTK 9.4 on
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

namespace palpate
{
namespace
{
// Pixels without a hit are discarded; depths are not interpolated, since a depth between two
// surfaces belongs to neither.
const char* const FragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D colors;
uniform sampler2D depths;
uniform vec3 outlineColor;
uniform vec2 outlineReach;
void main()
{
  vec4 color = texture(colors, texCoord);
  if (color.a == 0.0)
  {
    float nearest = 1.0;
    for (int k = 0; outlineReach.x > 0.0 && k < 16; ++k)
    {
      float angle = 0.3926991 * float(k);
      nearest = min(nearest,
        texture(depths, texCoord + outlineReach * vec2(cos(angle), sin(angle))).r);
    }
    if (nearest == 1.0)
    {
      discard;
    }
    gl_FragData[0] = vec4(outlineColor, 1.0);
    gl_FragDepth = nearest;
    return;
  }
  gl_FragData[0] = color;
  gl_FragDepth = texture(depths, texCoord).r;
}
)";
} // namespace

DepthImage::DepthImage() = default;
DepthImage::~DepthImage() = default;

void DepthImage::Load(vtkOpenGLRenderWindow* window, const FieldImage& image)
{
  const auto width = static_cast<unsigned int>(image.Width);
  const auto height = static_cast<unsigned int>(image.Height);
  // vtkTextureObject takes non-const pointers, but does not write to them.
  this->Colors->SetContext(window);
  this->Colors->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Colors->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Colors->Create2DFromRaw(width, height, 4, VTK_UNSIGNED_CHAR,
                                const_cast<std::uint8_t*>(image.Colors.data()));
  this->Depths->SetContext(window);
  this->Depths->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Depths->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Depths->Create2DFromRaw(width, height, 1, VTK_FLOAT,
                                const_cast<float*>(image.Depths.data()));
}

void DepthImage::SetOutline(const Vector3& color, double across, double down)
{
  for (int part = 0; part < 3; ++part)
  {
    this->OutlineColor[part] = static_cast<float>(color[part]);
  }
  this->OutlineReach[0] = static_cast<float>(across);
  this->OutlineReach[1] = static_cast<float>(down);
}

void DepthImage::Draw(vtkRenderer* renderer, const FieldImage& image, bool writesDepths)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (window == nullptr || image.Width <= 0 || image.Height <= 0)
  {
    return;
  }
  this->Load(window, image);
  if (!this->Quad)
  {
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, FragmentShader, "");
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  const vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(writesDepths ? GL_TRUE : GL_FALSE);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

  this->Colors->Activate();
  this->Depths->Activate();
  this->Quad->Program->SetUniformi("colors", this->Colors->GetTextureUnit());
  this->Quad->Program->SetUniformi("depths", this->Depths->GetTextureUnit());
  this->Quad->Program->SetUniform3f("outlineColor", this->OutlineColor);
  this->Quad->Program->SetUniform2f("outlineReach", this->OutlineReach);
  this->Quad->Render();
  this->Depths->Deactivate();
  this->Colors->Deactivate();
}

void DepthImage::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
  this->Colors->ReleaseGraphicsResources(window);
  this->Depths->ReleaseGraphicsResources(window);
}
} // namespace palpate

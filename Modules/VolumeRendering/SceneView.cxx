#include "SceneView.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

namespace palpate
{
namespace
{
Eigen::Matrix4d ToEigen(vtkMatrix4x4* matrix)
{
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(matrix->GetData());
}

std::vector<SurfaceLight> LightsOf(vtkRenderer* renderer)
{
  std::vector<SurfaceLight> lights;
  vtkCollectionSimpleIterator place;
  vtkLightCollection* all = renderer->GetLights();
  all->InitTraversal(place);
  while (vtkLight* light = all->GetNextLight(place))
  {
    if (light->GetSwitch() == 0)
    {
      continue;
    }
    Vector3 position;
    Vector3 focus;
    light->GetTransformedPosition(position.data());
    light->GetTransformedFocalPoint(focus.data());
    const double intensity = light->GetIntensity();
    const bool isPositional = light->GetPositional() != 0;
    lights.push_back({isPositional, isPositional ? position : (position - focus).normalized(),
                      intensity * Vector3(light->GetDiffuseColor()),
                      intensity * Vector3(light->GetSpecularColor())});
  }
  return lights;
}

std::vector<Eigen::Hyperplane<double, 3>> KeptHalves(vtkVolumeMapper* mapper,
                                                     const Eigen::Matrix4d& toScene)
{
  std::vector<Eigen::Hyperplane<double, 3>> kept;
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes != nullptr && i < planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    const Vector3 normal(plane->GetNormal());
    Eigen::Vector4d scene;
    scene << normal, -normal.dot(Vector3(plane->GetOrigin()));
    const Eigen::Vector4d own = toScene.transpose() * scene;
    kept.emplace_back(own.head<3>(), own[3]);
  }
  return kept;
}

SurfaceFinish FinishOf(vtkVolume* volume)
{
  vtkVolumeProperty* property = volume->GetProperty();
  return {property->GetShade() != 0, property->GetAmbient(), property->GetDiffuse(),
          property->GetSpecular(), property->GetSpecularPower()};
}
} // namespace

FieldView MakeSceneView(vtkRenderer* renderer, vtkVolume* volume, vtkVolumeMapper* mapper,
                        int width, int height)
{
  FieldView view;
  view.ToScene = ToEigen(volume->GetMatrix());
  const Eigen::Matrix4d toClip =
      ToEigen(renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
          renderer->GetTiledAspectRatio(), 0.0, 1.0));
  view.Rays = PixelRays(toClip * view.ToScene, width, height);
  view.Kept = KeptHalves(mapper, view.ToScene);
  view.Finish = FinishOf(volume);
  view.Lights = LightsOf(renderer);
  return view;
}

std::vector<float> ReadSceneDepths(vtkRenderer* renderer, int width, int height)
{
  int size[2];
  int corner[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &corner[0], &corner[1]);
  std::vector<float> all(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
  renderer->GetRenderWindow()->GetZbufferData(corner[0], corner[1], corner[0] + size[0] - 1,
                                              corner[1] + size[1] - 1, all.data());
  if (width == size[0] && height == size[1])
  {
    return all;
  }
  std::vector<float> depths;
  depths.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row)
  {
    const auto from = static_cast<std::size_t>((2 * row + 1) * size[1] / (2 * height));
    for (int column = 0; column < width; ++column)
    {
      const auto place = static_cast<std::size_t>((2 * column + 1) * size[0] / (2 * width));
      depths.push_back(all[from * static_cast<std::size_t>(size[0]) + place]);
    }
  }
  return depths;
}
} // namespace palpate

#include "ViewContents.h"

#include "DisplayedSurface.h"
#include "FitResult.h"
#include "ImageAxes.h"
#include "OwnCopy.h"
#include "PlainVector3.h"
#include "RadialModel.h"
#include "SceneProtection.h"
#include "SceneTool.h"
#include "ShownTick.h"
#include "SurfaceMaterial.h"
#include "ToolSurface.h"

#include "vtkBoundingBox.h"
#include "vtkImageData.h"
#include "vtkSubVoxelVolume.h"
#include "vtkSubVoxelVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <variant>

namespace palpate
{
namespace
{
const double* BoundsOf(vtkSurfaceDisplay& surface)
{
  return surface.GetSurface()->GetBounds();
}

const double* BoundsOf(vtkVolume& volume)
{
  return volume.GetBounds();
}

template <typename Shown>
std::optional<Vector3> MiddleOf(const std::map<int, vtkSmartPointer<Shown>>& shown, int id)
{
  const auto found = shown.find(id);
  if (found == shown.end())
  {
    return std::nullopt;
  }
  const double* box = BoundsOf(*found->second);
  return Vector3(0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]));
}

// The id of an object among those that are shown; 0 if it is none of them.
template <typename Shown>
int IdOf(const std::map<int, vtkSmartPointer<Shown>>& shown, const vtkObject* object)
{
  const auto found = std::find_if(shown.begin(), shown.end(),
                                  [object](const auto& one) { return one.second == object; });
  return found != shown.end() ? found->first : 0;
}

template <typename Shown>
void KeepOnly(std::map<int, Shown>& shown, const std::set<int>& labels)
{
  for (auto one = shown.begin(); one != shown.end();)
  {
    one = labels.count(one->first) == 0 ? shown.erase(one) : std::next(one);
  }
}
} // namespace

ViewContents::ViewContents()
{
  this->ProbeShown->VisibilityOff();
  this->HeldShown->VisibilityOff();
  this->HeldShown->SetColor(0.34, 0.71, 0.91); // Okabe and Ito's sky blue, unlike organs
  this->HeldShown->SetOpacity(0.75);
  this->HeldShown->SetLineWidth(2.0);
  this->HeldShown->PickableOff();
  this->WorkspaceShown->VisibilityOff();
  this->WorkspaceShown->WireframeOn();
  this->WorkspaceShown->SetLineWidth(1.0);
  this->WorkspaceShown->SetColor(0.8, 0.47, 0.65); // Okabe and Ito's reddish purple
}

void ViewContents::Show(const StudyState& state, const StudyPipeline& pipeline)
{
  double center[3];
  if (this->Pictures.Show(state, pipeline) && this->Images()->GetCenterWorld(center))
  {
    this->CrosshairShown->SetPositionWorld(center);
  }
  this->Places.Take(state, this->Pictures.Labels());
  this->Pictures.ShowLabels(state, this->Places);
  TouchToolSettings tool = state.Tool;
  tool.Surface = pipeline.Newest<SurfaceTool>(SceneStep::Tool);
  this->ShowTool(tool);
  this->ShowSurfaces(state, pipeline);
  this->FollowSurfaces();
  this->Marks.Show(state);
  this->ShowView(state.View);
}

void ViewContents::ShowDrawing(const DrawnOrgan& organ, const StudyDrawing& drawing, bool areMarked)
{
  this->Drawn.Show(organ);
  this->Marks.ShowDrawing(drawing, areMarked ? organ.Next() : std::vector<Vector3>());
}

void ViewContents::ShowHeld(int id, vtkPolyData* surface)
{
  this->HeldShown->SetVisibility(surface != nullptr);
  if (surface != nullptr)
  {
    this->HeldShown->SetSurface(surface);
  }
  for (const auto& [own, shown] : this->SurfacesShown)
  {
    shown->SetVisibility(own != id || surface == nullptr);
  }
}

// Without a volume, slices are through the middle of what is shown, until the user moves them.
void ViewContents::FollowSurfaces()
{
  std::set<int> shown;
  vtkBoundingBox box;
  for (const auto& [id, surface] : this->SurfacesShown)
  {
    shown.insert(id);
    box.AddBounds(BoundsOf(*surface));
  }
  if (this->Images()->GetImage() != nullptr || !box.IsValid())
  {
    this->Followed.clear();
    return;
  }
  const Vector3 crosshair(this->CrosshairShown->GetPositionWorld());
  if (this->Followed.empty() || (crosshair == this->FollowedWorld && shown != this->Followed))
  {
    box.GetCenter(this->FollowedWorld.data());
    this->CrosshairShown->SetPositionWorld(this->FollowedWorld.data());
  }
  this->Followed = std::move(shown);
}

void ViewContents::ShowSurfaces(const StudyState& state, const StudyPipeline& pipeline)
{
  std::set<int> surfaces;
  std::set<int> fields;
  this->Touchable.clear();
  for (const SceneStructure& structure : state.Structures)
  {
    if (structure.IsTouchable)
    {
      this->Touchable.insert(structure.Id);
    }
    if (!structure.IsVisible || this->Corrected.IsOf(structure.Id))
    {
      continue;
    }
    // Until the wanted surface is ready, show the existing one.
    vtkPolyData* yielding = this->ShowYielding(structure, pipeline);
    vtkPolyData* surface = yielding != nullptr ? yielding : SurfaceOf(pipeline, structure);
    const auto field = pipeline.Newest<ScalarField>(SceneStep::Field, structure.Id);
    if (field != nullptr && (surface == nullptr || WantsField(structure)))
    {
      fields.insert(structure.Id);
      this->ShowField(structure, field);
      this->ShowNewest(structure.Id);
    }
    else if (surface != nullptr)
    {
      surfaces.insert(structure.Id);
      this->ShowSurface(structure, surface);
    }
  }
  KeepOnly(this->SurfacesShown, surfaces);
  KeepOnly(this->SurfaceSources, surfaces);
  KeepOnly(this->FieldsShown, fields);
  KeepOnly(this->FieldSources, fields);
  KeepOnly(this->Yielding, surfaces);
  this->ShowOpacities(state);
  this->ShowOutlines(state, pipeline);
}

// A forbidden structure is outlined whether it is visible or not. Its protection has a surface,
// too.
void ViewContents::ShowOutlines(const StudyState& state, const StudyPipeline& pipeline)
{
  std::set<int> outlines;
  for (const SceneStructure& structure : state.Structures)
  {
    if (!structure.IsForbidden || this->SurfacesShown.count(structure.Id) > 0)
    {
      continue;
    }
    const auto protection = pipeline.Newest<SceneProtection>(SceneStep::Protection, structure.Id);
    vtkPolyData* surface =
        protection != nullptr ? protection->Structure->Surface() : SurfaceOf(pipeline, structure);
    if (surface == nullptr)
    {
      continue;
    }
    outlines.insert(structure.Id);
    auto& shown = this->OutlinesShown[structure.Id];
    if (shown == nullptr)
    {
      shown = vtkSmartPointer<vtkSurfaceDisplay>::New();
      shown->VisibilityOff();
      shown->ForbiddenOn();
      this->OutlineSources.erase(structure.Id);
    }
    if (this->OutlineSources[structure.Id] != surface)
    {
      this->OutlineSources[structure.Id] = surface;
      shown->SetSurface(OwnCopy(surface));
    }
  }
  KeepOnly(this->OutlinesShown, outlines);
  KeepOnly(this->OutlineSources, outlines);
}

// The surface of a structure that yields, or null.
vtkPolyData* ViewContents::ShowYielding(const SceneStructure& structure,
                                        const StudyPipeline& pipeline)
{
  const auto model = YieldingModelOf(pipeline, structure);
  if (model == nullptr)
  {
    this->Yielding.erase(structure.Id);
    return nullptr;
  }
  auto& yielding = this->Yielding[structure.Id];
  if (yielding == nullptr || yielding->Maps() != model->Elasticity.get())
  {
    yielding =
        std::make_unique<YieldingSurface>(std::get<RadialModel>(model->Model), model->Elasticity);
  }
  if (structure.Appearance == SceneAppearance::StiffnessMap)
  {
    yielding->MapStiffness(this->BallRadius());
  }
  return yielding->Surface();
}

// A structure that yields is more translucent if another one lies in it.
void ViewContents::ShowOpacities(const StudyState& state)
{
  constexpr double Translucent = 0.5;
  for (const SceneStructure& structure : state.Structures)
  {
    const auto shown = this->SurfacesShown.find(structure.Id);
    if (shown != this->SurfacesShown.end())
    {
      const double factor = this->HoldsAnother(structure.Id) ? Translucent : 1.0;
      shown->second->SetOpacity(factor * structure.Opacity);
    }
  }
}

// Whether a structure yields and another one lies in it, unless it is coloured by a map.
bool ViewContents::HoldsAnother(int id) const
{
  const auto yielding = this->Yielding.find(id);
  if (yielding == this->Yielding.end() || *this->SurfacesShown.at(id)->GetColorArray() != '\0')
  {
    return false;
  }
  const vtkBoundingBox box(yielding->second->Surface()->GetBounds());
  return std::any_of(this->SurfacesShown.begin(), this->SurfacesShown.end(),
                     [&](const auto& other)
                     {
                       return other.first != id &&
                              box.Contains(vtkBoundingBox(other.second->GetSurface()->GetBounds()));
                     });
}

void ViewContents::ShowSurface(const SceneStructure& structure, vtkPolyData* surface)
{
  auto& shown = this->SurfacesShown[structure.Id];
  if (shown == nullptr)
  {
    shown = vtkSmartPointer<vtkSurfaceDisplay>::New();
    this->ShowHighlight(structure.Id);
    this->SurfaceSources.erase(structure.Id);
  }
  if (this->SurfaceSources[structure.Id] != surface)
  {
    this->SurfaceSources[structure.Id] = surface;
    // The surface of a structure that yields is its own, and changes.
    const bool isOwn = this->Yielding.count(structure.Id) > 0;
    shown->SetSurface(isOwn ? vtkSmartPointer<vtkPolyData>(surface) : OwnCopy(surface));
  }
  shown->SetColor(structure.Color[0], structure.Color[1], structure.Color[2]);
  shown->SetColorArray(ColorArrayOf(structure.Appearance));
  shown->SetForbidden(structure.IsForbidden);
}

void ViewContents::ShowField(const SceneStructure& structure,
                             const std::shared_ptr<const ScalarField>& field)
{
  auto& shown = this->FieldsShown[structure.Id];
  auto& source = this->FieldSources[structure.Id];
  if (shown == nullptr || source != field)
  {
    source = field;
    vtkNew<vtkSubVoxelVolumeMapper> mapper;
    mapper->SetField(field);
    shown = vtkSmartPointer<vtkSubVoxelVolume>::New();
    shown->SetMapper(mapper);
    shown->GetProperty()->ShadeOn(); // like surfaces
    SurfaceMaterial::Set(shown->GetProperty());
    this->ShowHighlight(structure.Id);
  }
  auto* mapper = vtkSubVoxelVolumeMapper::SafeDownCast(shown->GetMapper());
  std::array<double, 3> color{};
  mapper->GetMaterialColor(0, color.data());
  if (color != structure.Color || mapper->GetMaterialOpacity(0) != structure.Opacity)
  {
    mapper->SetMaterialColor(0, structure.Color[0], structure.Color[1], structure.Color[2]);
    mapper->SetMaterialOpacity(0, structure.Opacity);
    shown->Modified(); // views check its modification time
  }
}

void ViewContents::Highlight(const std::set<int>& ids)
{
  std::set<int> changed = ids;
  changed.insert(this->Highlighted.begin(), this->Highlighted.end());
  this->Highlighted = ids;
  for (const int id : changed)
  {
    this->ShowHighlight(id);
  }
}

void ViewContents::ShowHighlight(int id)
{
  const bool isOn = this->Highlighted.count(id) > 0;
  const auto surface = this->SurfacesShown.find(id);
  if (surface != this->SurfacesShown.end())
  {
    surface->second->SetHighlight(isOn);
  }
  const auto field = this->FieldsShown.find(id);
  if (field != this->FieldsShown.end())
  {
    constexpr double Width = 2.0; // pixels
    auto* mapper = vtkSubVoxelVolumeMapper::SafeDownCast(field->second->GetMapper());
    if ((mapper->GetOutlineWidth() > 0.0) != isOn)
    {
      mapper->SetOutlineWidth(isOn ? Width : 0.0);
      field->second->Modified(); // views check its modification time
    }
  }
}

int ViewContents::StructureAt(const vtkObject* picked, const Vector3& pointWorld) const
{
  if (picked == this->Images())
  {
    return this->StructureAt(pointWorld);
  }
  const int surface = IdOf(this->SurfacesShown, picked);
  return surface != 0 ? surface : IdOf(this->FieldsShown, picked);
}

std::optional<Vector3> ViewContents::CenterOf(int id) const
{
  if (auto center = this->Places.CenterOf(id))
  {
    return center;
  }
  const auto surface = MiddleOf(this->SurfacesShown, id);
  return surface ? surface : MiddleOf(this->FieldsShown, id);
}

// Shows a drilled structure's newest version instead of its original field.
void ViewContents::ShowNewest(int label)
{
  const auto newest = this->DrilledFields.find(label);
  const auto shown = this->FieldsShown.find(label);
  if (shown == this->FieldsShown.end())
  {
    return;
  }
  const auto& field =
      newest != this->DrilledFields.end() ? newest->second : this->FieldSources.at(label);
  auto* mapper = vtkSubVoxelVolumeMapper::SafeDownCast(shown->second->GetMapper());
  if (mapper->GetField() != field)
  {
    mapper->SetField(field);
    shown->second->Modified(); // views check its modification time
  }
}

bool ViewContents::ShowDrilled(const StudyDrillReading& reading)
{
  bool areOthers = false;
  std::set<int> labels;
  const auto before = std::exchange(this->DrilledFields, {});
  for (const StudyDrilled& one : reading.Drilled)
  {
    this->DrilledFields[one.Id] = one.Field;
  }
  for (const auto& [id, field] : before)
  {
    this->ShowNewest(id);
  }
  for (const StudyDrilled& one : reading.Drilled)
  {
    this->ShowNewest(one.Id);
    if (one.Cut == nullptr || one.Cut->GetNumberOfCells() == 0)
    {
      continue;
    }
    labels.insert(one.Id);
    auto& cut = this->CutsShown[one.Id];
    if (cut == nullptr)
    {
      cut = vtkSmartPointer<vtkSurfaceDisplay>::New();
      cut->SetOpacity(0.0); // the 3D view shows the hole itself
      cut->SetColor(1.0, 0.55, 0.0);
      areOthers = true;
    }
    if (cut->GetSurface() != one.Cut)
    {
      cut->SetSurface(one.Cut);
    }
  }
  areOthers = areOthers || labels.size() != this->CutsShown.size();
  KeepOnly(this->CutsShown, labels);
  return areOthers;
}

void ViewContents::ShowTool(const TouchToolSettings& tool)
{
  // Until a surface is read, the previous tool is shown.
  const bool isThere = tool.Kind != TouchToolSettings::Shape::Surface || tool.Surface != nullptr;
  if (isThere && (!this->Tool || !(*this->Tool == tool)))
  {
    this->Tool = tool;
    this->ProbeShown->SetTool(MakeToolSurface(MakeTool(tool)));
  }
}

void ViewContents::ShowView(const StudyView& view)
{
  if (view.CrosshairWorld)
  {
    this->CrosshairShown->SetPositionWorld(view.CrosshairWorld->data());
  }
  if (view.Window && view.Level)
  {
    this->Images()->SetWindowLevel(*view.Window, *view.Level);
  }
  this->Images()->SetLabelOpacity(view.OverlayOpacity);
  this->ShowErrorScale(view);
  this->Images()->SetMixing(static_cast<int>(view.Mixing));
  this->Images()->SetCurtain(view.Curtain);
}

// Unless it is chosen, the scale depends on the mask alone, so that pictures of several fits can be
// compared.
void ViewContents::ShowErrorScale(const StudyView& view)
{
  constexpr double Voxels = 2.0;
  const auto& labels = this->Pictures.Labels();
  const double* spacing = labels != nullptr ? labels->Layers.front()->GetSpacing() : nullptr;
  const double ofMask = spacing != nullptr ? Voxels * *std::max_element(spacing, spacing + 3) : 0.0;
  for (const auto& [id, surface] : this->SurfacesShown)
  {
    const bool isErrorMap =
        std::string(surface->GetColorArray()) == ColorArrayOf(SceneAppearance::ErrorMap);
    surface->SetColorLimit(isErrorMap ? view.ErrorScale.value_or(ofMask) : 0.0);
  }
}

StudyView ViewContents::WithViewOf(StudyView view) const
{
  if (this->Images()->GetImage() != nullptr)
  {
    view.CrosshairWorld = Vector3(this->CrosshairShown->GetPositionWorld());
    view.Window = this->Images()->GetWindow();
    view.Level = this->Images()->GetLevel();
  }
  view.OverlayOpacity = this->Images()->GetLabelOpacity();
  return view;
}

void ViewContents::ShowTouch(const StudyTouchReading& reading, bool isTouching)
{
  const TouchState& state = reading.Newest;
  this->ShowDent(reading, isTouching && state.HasSample && !this->IsHandOnly);
  this->ProbeShown->SetVisibility(isTouching && state.HasSample);
  if (!isTouching || !state.HasSample)
  {
    return;
  }
  // The tool is in the dent of a structure that yields, not on its surface at rest.
  const bool isAtHand = this->IsHandOnly || this->Yielding.count(reading.TouchedId) > 0;
  ShowTick(state, {isAtHand, !this->IsHandOnly && !this->IsForceHidden}, *this->ProbeShown);
  this->ShowDepth(isAtHand ? state.ProbeWorld : state.ProxyWorld);
}

// Distance of the tool from the displayed surfaces.
void ViewContents::ShowDepth(const Vector3& toolWorld)
{
  constexpr double Farthest = 200.0; // mm
  if (this->ProbeShown->GetInContact())
  {
    return;
  }
  std::vector<vtkPolyData*> surfaces;
  for (const auto& [id, shown] : this->SurfacesShown)
  {
    if (shown->GetSurface() != nullptr)
    {
      surfaces.push_back(shown->GetSurface());
    }
  }
  this->Around.SetSurfaces(surfaces);
  if (const auto nearest = this->Around.Find(toolWorld, Farthest))
  {
    this->ProbeShown->SetNearestPoint(nearest->x(), nearest->y(), nearest->z());
  }
  else
  {
    this->ProbeShown->ClearNearestPoint();
  }
}

// Only a sphere touches what yields; 0 for another tool.
double ViewContents::BallRadius() const
{
  const bool isBall = this->Tool && this->Tool->Kind == TouchToolSettings::Shape::Sphere;
  return isBall ? this->Tool->Radius : 0.0;
}

// In each structure that the tool presses, not only in the one that it presses most.
void ViewContents::ShowDent(const StudyTouchReading& reading, bool isTouching)
{
  const TouchState& newest = reading.Newest;
  const bool isPressing = isTouching && reading.TouchedId != 0;
  for (const auto& [id, yielding] : this->Yielding)
  {
    if (isPressing && id == reading.TouchedId)
    {
      yielding->Press(newest.ProxyWorld, newest.ProbeWorld, this->BallRadius());
    }
    else if (isPressing && this->Touchable.count(id) != 0)
    {
      yielding->Press(newest.ProbeWorld, this->BallRadius());
    }
    else
    {
      yielding->Release();
    }
  }
}

void ViewContents::ShowWorkspace(const WorkspaceFrame& frame, const Eigen::AlignedBox3d& box,
                                 bool isShown)
{
  this->WorkspaceShown->SetVisibility(isShown && !box.isEmpty());
  if (!this->WorkspaceShown->GetVisibility())
  {
    return;
  }
  std::array<Vector3, 8> corners;
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    corners[c] = frame.ToWorld(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(c)));
  }
  if (this->WorkspaceShown->GetSurface() == nullptr || corners != this->WorkspaceCorners)
  {
    this->WorkspaceCorners = corners;
    this->WorkspaceShown->SetSurface(MakeBox(corners));
  }
}
} // namespace palpate

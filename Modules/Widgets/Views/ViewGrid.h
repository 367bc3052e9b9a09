#pragma once

#include "SlicePane.h"
#include "SpacePane.h"
#include "ViewContents.h"

#include "vtkImageData.h"

#include <QGridLayout>
#include <QWidget>

#include <array>
#include <set>
#include <string>

namespace palpate
{
/// Arrangement of a window's views.
enum class ViewLayout
{
  Four,  ///< two by two
  Space, ///< the 3D view, with slices next to it
  One    ///< a single view
};
constexpr std::array<ViewLayout, 3> AllViewLayouts{
    {ViewLayout::Four, ViewLayout::Space, ViewLayout::One}};

/// "four", "space", "one": the names in session files.
const char* WordOf(ViewLayout layout);
/// The first one for an unknown word.
ViewLayout LayoutOf(const std::string& word);

/// Three slices and the 3D view, linked by shared objects.
class ViewGrid : public QWidget
{
  Q_OBJECT

public:
  /// Shows `contents`, which outlive it.
  explicit ViewGrid(ViewContents& contents, QWidget* parent = nullptr);

  SlicePane* Slice(SliceOrientation orientation) const
  {
    return this->Slices[static_cast<std::size_t>(orientation)];
  }
  SpacePane* Space() const { return this->InSpace; }
  const std::array<ViewPane*, 4>& Panes() const { return this->All; }

  void SetLayout(ViewLayout layout);
  ViewLayout Layout() const { return this->Shown; }
  /// Shows one view alone, or all again.
  void ToggleMaximized(ViewPane* pane);

  /// Takes over the current surfaces and fields of the contents.
  void TakeContents();
  void SetAlongImage(bool isAlongImage);
  void SetLeftButtonMode(int mode);
  /// See vtkSliceView::SetNeurological.
  void SetNeurological(bool isNeurological);
  void SetLengthUnit(LengthUnit unit);
  void FitAll();
  /// In the 3D view, or in the only visible one.
  void ShowNotice(const TouchNotice& notice);

private:
  void Arrange();
  void FitToAnotherImage();
  void Put(ViewPane* pane, int row, int column, int rows, int columns);

  ViewContents& Contents;
  std::array<SlicePane*, 3> Slices{};
  SpacePane* InSpace;
  std::array<ViewPane*, 4> All{};
  QGridLayout* Grid;
  ViewLayout Shown = ViewLayout::Four;
  ViewPane* Alone = nullptr;
  TouchNotice Notice;
  ViewPane* One; ///< the view of layout One
  std::set<vtkSmartPointer<vtkSurfaceDisplay>> Surfaces;
  vtkSmartPointer<vtkImageData> Image; ///< the image that the views were fitted to
};
} // namespace palpate

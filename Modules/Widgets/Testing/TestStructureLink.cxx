#include "SlicePainter.h"
#include "StructuresPanel.h"
#include "WindowTest.h"

#include "vtkSubVoxelVolumeMapper.h"
#include "vtkVolumeProperty.h"

namespace palpate::structure_link_test
{
namespace
{
// A window with the phantom: label 1 is a sphere of 9 mm around (-15, 0, 0).
class StructureLinkTest : public test::WindowTest
{
protected:
  StructuresPanel* Panel() const { return this->Window->findChild<StructuresPanel*>(); }
  StructureTable* Table() const { return this->Window->findChild<StructureTable*>(); }
  void ClickRow(int row)
  {
    const QModelIndex cell = this->Table()->model()->index(row, StructureTableModel::NameColumn);
    this->Table()->scrollTo(cell);
    Click(this->Table()->viewport(), this->Table()->visualRect(cell).center());
  }
  bool Write(int row, int column, const QVariant& value)
  {
    QAbstractItemModel* model = this->Table()->model();
    return model->setData(model->index(row, column), value);
  }
  Vector3 Crosshair() const
  {
    return Vector3(this->Window->Contents().Crosshair()->GetPositionWorld());
  }
  void SendDrag(QWidget* widget, const QPointF& from, const QPointF& to)
  {
    SendMouse(widget, QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    SendMouse(widget, QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
    SendMouse(widget, QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
  }

  const Vector3 SphereCenter{-15.0, 0.0, 0.0};
};

using Ids = std::vector<int>;

TEST_F(StructureLinkTest, SelectedRowIsCentredAndHighlighted)
{
  this->OpenPhantom();
  const ViewContents& shown = this->Window->Contents();
  this->ClickRow(0);
  EXPECT_LT((this->Crosshair() - this->SphereCenter).norm(), 1.0) << "a voxel";
  EXPECT_TRUE(shown.Surfaces().at(1)->GetHighlight());
  const std::string undo = this->Study->Current().History().UndoText();
  this->ClickRow(1);
  // The centroid of a horseshoe lies outside of it.
  EXPECT_EQ(shown.StructureAt(this->Crosshair()), 2);
  EXPECT_FALSE(shown.Surfaces().at(1)->GetHighlight());
  EXPECT_EQ(this->Study->Current().History().UndoText(), undo) << "no undo step";
}

TEST_F(StructureLinkTest, HiddenStructureIsCentredToo)
{
  this->OpenPhantom();
  StudyState next = this->Study->State();
  next.Structures[0].IsVisible = next.Structures[0].IsTouchable = false;
  this->Study->Change("Hide it", next);
  this->ClickRow(0);
  EXPECT_LT((this->Crosshair() - this->SphereCenter).norm(), 1.0);
  EXPECT_EQ(this->Window->Contents().StructureAt(this->SphereCenter), 0) << "it is hidden";
}

TEST_F(StructureLinkTest, ClickIn3DSelectsTheRowAndLeavesTheSlices)
{
  this->OpenPhantom();
  const Vector3 before = this->Crosshair();
  QWidget* canvas = this->Window->Views()->Space()->Canvas();
  Click(canvas, this->PlaceOf(this->SphereCenter));
  EXPECT_EQ(this->Panel()->SelectedIds(), Ids{1});
  EXPECT_TRUE(this->Window->Contents().Surfaces().at(1)->GetHighlight());
  EXPECT_EQ(this->Crosshair(), before);
}

TEST_F(StructureLinkTest, DragIn3DSelectsNothing)
{
  this->OpenPhantom();
  const QPointF place = this->PlaceOf(this->SphereCenter);
  this->SendDrag(this->Window->Views()->Space()->Canvas(), place, place + QPointF(20.0, 5.0));
  EXPECT_TRUE(this->Panel()->SelectedIds().empty());
}

TEST_F(StructureLinkTest, ClickInASliceSelectsTheLabelThere)
{
  this->OpenPhantom();
  SlicePane* axial = this->Window->Views()->Slice(SliceOrientation::Axial);
  const QPointF middle(0.5 * axial->Canvas()->width(), 0.5 * axial->Canvas()->height());
  const double left = -15.0 / axial->View()->GetPixelMillimeters();
  Click(axial->Canvas(), middle + QPointF(left, 0.0));
  EXPECT_EQ(this->Panel()->SelectedIds(), Ids{1});
  EXPECT_NEAR(this->Crosshair().x(), -15.0, 1.0) << "the crosshair is where was clicked";
}

TEST_F(StructureLinkTest, ClicksThatPlaceLandmarksSelectNothing)
{
  this->OpenPhantom();
  this->Button("add-landmarks")->setChecked(true);
  Click(this->Window->Views()->Space()->Canvas(), this->PlaceOf(this->SphereCenter));
  EXPECT_TRUE(this->Panel()->SelectedIds().empty());
  EXPECT_EQ(this->Study->State().Landmarks.size(), 1U);
}

TEST_F(StructureLinkTest, OpacityIsThatOfTheSurfaceAndOfTheLabel)
{
  this->OpenPhantom();
  const ViewContents& shown = this->Window->Contents();
  EXPECT_TRUE(this->Write(0, StructureTableModel::OpacityColumn, 25));
  EXPECT_EQ(shown.Surfaces().at(1)->GetOpacity(), 0.25);
  EXPECT_EQ(shown.Surfaces().at(2)->GetOpacity(), 1.0);
  EXPECT_EQ(shown.Images()->GetContent().Layers.at(0).Colors.at(1)[3], 0.25F);
  EXPECT_EQ(shown.Images()->GetContent().Layers.at(0).Colors.at(2)[3], 1.0F);
  this->Study->Undo();
  EXPECT_EQ(shown.Surfaces().at(1)->GetOpacity(), 1.0);
}

TEST_F(StructureLinkTest, SubVoxelVolumeHasOpacityAndHighlight)
{
  this->OpenPhantom();
  const ViewContents& shown = this->Window->Contents();
  this->Write(0, StructureTableModel::AppearanceColumn,
              static_cast<int>(SceneAppearance::SubVoxel));
  WaitUntil([&] { return shown.Fields().count(1) == 1; });
  this->Write(0, StructureTableModel::OpacityColumn, 40);
  vtkVolume* volume = shown.Fields().at(1);
  auto* mapper = vtkSubVoxelVolumeMapper::SafeDownCast(volume->GetMapper());
  EXPECT_EQ(mapper->GetMaterialOpacity(0), 0.4);
  EXPECT_EQ(mapper->GetOutlineWidth(), 0.0);
  this->Panel()->Select(1);
  EXPECT_GT(mapper->GetOutlineWidth(), 0.0);
  EXPECT_EQ(shown.StructureAt(volume, this->SphereCenter), 1);
}
} // namespace
} // namespace palpate::structure_link_test

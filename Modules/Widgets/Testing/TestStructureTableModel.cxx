#include "StructureTableModel.h"
#include "WindowTest.h"

#include <QTableView>

namespace palpate
{
namespace
{
class StructureTableTest : public test::WindowTest
{
protected:
  QAbstractItemModel* Table() const
  {
    return this->Window->findChild<QTableView*>("structures")->model();
  }
  bool Write(int row, int column, const QVariant& value, int role = Qt::EditRole)
  {
    return this->Table()->setData(this->Table()->index(row, column), value, role);
  }
  const StudyStructure& First() const { return this->Study->State().Structures.front(); }
};

TEST_F(StructureTableTest, WhatIsWrittenIsAStepOfTheStudy)
{
  this->OpenPhantom();
  ASSERT_EQ(this->Table()->rowCount(), 3);
  EXPECT_TRUE(this->Write(0, StructureTableModel::StiffnessColumn, 1.25));
  EXPECT_EQ(this->First().Stiffness, 1.25);
  EXPECT_EQ(this->Study->Current().History().UndoText(), "Change label 1: stiffness 1.25 N/mm");
  EXPECT_TRUE(this->Write(0, StructureTableModel::NameColumn, "ball"));
  EXPECT_EQ(this->First().Name, "ball");
  EXPECT_TRUE(this->Write(0, StructureTableModel::RepresentationColumn, 2));
  EXPECT_EQ(this->First().Representation, TouchRepresentation::Facets);
  EXPECT_TRUE(this->Write(0, StructureTableModel::FrictionColumn, 0.5));
  EXPECT_EQ(this->First().Friction.Static, 0.5);
  EXPECT_EQ(this->First().Friction.Dynamic, 0.4);
  EXPECT_TRUE(this->Write(0, StructureTableModel::DegreeColumn, 1000));
  EXPECT_EQ(this->First().Degree, 64);
  for (int step = 0; step < 5; ++step)
  {
    this->Study->Undo();
  }
  EXPECT_EQ(this->First().Name, "");
  EXPECT_EQ(this->First().Stiffness, 0.5);
}

TEST_F(StructureTableTest, WhatIsHiddenIsInNoView)
{
  this->OpenPhantom();
  ASSERT_EQ(this->Window->Contents().Surfaces().count(1), 1U);
  EXPECT_TRUE(
      this->Write(0, StructureTableModel::VisibleColumn, Qt::Unchecked, Qt::CheckStateRole));
  EXPECT_FALSE(this->First().IsVisible);
  EXPECT_EQ(this->Window->Contents().Surfaces().count(1), 0U);
  this->Study->Undo();
  EXPECT_EQ(this->Window->Contents().Surfaces().count(1), 1U);
}

TEST_F(StructureTableTest, ATicksCostIsShownForWhatCanBeTouched)
{
  this->OpenPhantom();
  const auto cost = [this](int row)
  { return this->Table()->index(row, StructureTableModel::CostColumn).data().toString(); };
  WaitUntil([&] { return cost(0) != QString("\u2013"); });
  EXPECT_GE(cost(0).toDouble(), 0.0); // in hundredths of a microsecond
  EXPECT_EQ(cost(2), QString("\u2013")) << "of one voxel, which is refused";
}

TEST_F(StructureTableTest, QualityIsTheModelsAndCannotBeWritten)
{
  this->OpenPhantom();
  const QModelIndex quality = this->Table()->index(0, StructureTableModel::QualityColumn);
  const auto model = this->Study->Current().Pipeline().Newest<FitResult>(StudyStep::Model, 1);
  ASSERT_NE(model, nullptr);
  // Shown to a micrometre.
  EXPECT_NEAR(quality.data().toDouble(), model->ModelToMask.Mean, 0.00051);
  EXPECT_FALSE(this->Write(0, StructureTableModel::QualityColumn, 0.0));
  EXPECT_FALSE(this->Table()->flags(quality) & Qt::ItemIsEditable);
  // Of what was refused there is none.
  EXPECT_EQ(this->Table()->index(1, StructureTableModel::QualityColumn).data().toString(),
            QString(QChar(0x2013)));
}
} // namespace
} // namespace palpate

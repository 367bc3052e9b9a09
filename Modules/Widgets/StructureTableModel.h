#pragma once

#include "StudyController.h"

#include <QAbstractTableModel>

namespace palpate
{
/// The structures of a study as a table. Each edit is an undo step of the study.
class StructureTableModel : public QAbstractTableModel
{
  Q_OBJECT

public:
  enum Column
  {
    NameColumn,
    ColorColumn,
    VisibleColumn,
    TouchableColumn,
    AppearanceColumn,
    RepresentationColumn,
    DegreeColumn,
    StiffnessColumn,
    FrictionColumn,
    QualityColumn,
    CostColumn,
    ColumnCount
  };
  /// In the order of SceneAppearance.
  static QStringList AppearanceNames();
  /// In the order of SceneRepresentations.
  static QStringList RepresentationNames();

  /// Keeps the address.
  StructureTableModel(StudyController& study, QObject* parent);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
  void TakeState();
  const SceneStructure& StructureAt(const QModelIndex& index) const;
  QVariant ValueOf(const SceneStructure& structure, int column) const;
  QVariant QualityOf(const SceneStructure& structure) const;
  QVariant CostOf(const SceneStructure& structure) const;
  QString RepresentationOf(const SceneStructure& structure) const;
  bool Yields(const SceneStructure& structure) const;

  StudyController& Study;
  int Rows = 0;
};
} // namespace palpate

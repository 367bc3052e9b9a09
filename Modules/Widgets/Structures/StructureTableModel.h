#pragma once

#include "StructureEdits.h"
#include "StructureStatus.h"
#include "StructureVerdicts.h"
#include "StudyController.h"

#include <QAbstractTableModel>

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace palpate
{
/// The structures of a study as a table. Each edit is an undo step of the study.
class StructureTableModel : public QAbstractTableModel
{
  Q_OBJECT

public:
  enum Column
  {
    VisibleColumn,
    TouchableColumn,
    ColorColumn,
    OpacityColumn,
    NameColumn,
    DrillColumn,
    StatusColumn,
    AlarmColumn,
    AppearanceColumn,
    RepresentationColumn,
    DegreeColumn,
    StiffnessColumn,
    FrictionColumn,
    QualityColumn,
    CostColumn,
    ColumnCount
  };
  enum Role
  {
    SortRole = Qt::UserRole + 1, ///< a number or a text
    IdRole                       ///< the structure's, of every column
  };
  /// In the order of SceneAppearance.
  static QStringList AppearanceNames();
  /// In the order of SceneRepresentations.
  static QStringList RepresentationNames();

  /// Keeps the addresses.
  StructureTableModel(StudyController& study, const StructureVerdicts& verdicts, QObject* parent);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
  // What the pipeline has made of a structure, as shown.
  struct Made
  {
    QString Representation;      ///< includes the replacement if harmonics were refused
    QString Represented;         ///< what is touched, as the command line prints it
    bool Yields = false;         ///< then its stiffness does not count
    std::optional<double> Error; ///< mm
    std::optional<double> Tick;  ///< microseconds
    std::optional<double> Cut;   ///< mm^2 of its surface that the border of the image cuts
  };
  struct Row
  {
    SceneStructure Structure;
    Made Products;
  };

  void TakeState();
  void TakeDrill();
  void TakeVerdicts();
  void TellRows(const std::vector<Row>& before, int firstColumn, int lastColumn,
                const std::function<bool(const Row& before, const Row& now)>& isSame);
  Made MadeOf(const SceneStructure& structure) const;
  StructureStatus StatusOf(const Row& row) const;
  QVariant TextOf(const Row& row, int column) const;
  static QVariant ValueOf(const Row& row, int column);
  QVariant SortValueOf(const Row& row, int column) const;
  static QVariant CheckOf(const Row& row, int column);

  StudyController& Study;
  const StructureVerdicts& Verdicts;
  StructureEdits Edits;
  std::vector<Row> Rows;          ///< as told to views
  std::map<int, QString> Drilled; ///< by ids, as told to views
};
} // namespace palpate

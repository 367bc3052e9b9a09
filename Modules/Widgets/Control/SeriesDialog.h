#pragma once

#include "DicomFolders.h"

#include <QDialog>

#include <vector>

class QTableWidget;

namespace palpate
{
/// Asks which series of DICOM slices to open, with a picture, description, size, orientation, date
/// and folder of each. A click on a column's head sorts; a double click opens.
class SeriesDialog : public QDialog
{
  Q_OBJECT

public:
  static constexpr int PreviewSide = 72; ///< pixels

  SeriesDialog(const std::vector<DicomSeriesChoice>& series, QWidget* parent);

  /// Number of the chosen one, from 0; -1 if there is none.
  int Chosen() const;

private:
  void AddRow(const DicomSeriesChoice& series, int number);

  QTableWidget* Table;
};
} // namespace palpate

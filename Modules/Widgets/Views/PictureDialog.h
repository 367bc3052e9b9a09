#pragma once

#include "ViewGrid.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QImage>
#include <QSpinBox>

namespace palpate
{
/// Asks which picture of a window's views to save, and draws it.
class PictureDialog : public QDialog
{
  Q_OBJECT

public:
  static constexpr int LargestSize = 8192; ///< pixels; what every OpenGL driver of today can draw

  /// Keeps the address of the views.
  PictureDialog(const ViewGrid& views, QWidget* window);

  /// The chosen picture, as things are now.
  QImage Picture() const;
  /// For its file: "axial.png", ...
  QString ProposedName() const;

private:
  ViewPane* View() const; ///< the chosen view; null for all, or the window
  bool IsOfWindow() const;
  void ProposeSize();

  const ViewGrid& Views;
  QWidget* Window;
  QComboBox* Content;
  QSpinBox* Across;
  QSpinBox* Down;
  QCheckBox* Transparent;
};
} // namespace palpate

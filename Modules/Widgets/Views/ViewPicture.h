#pragma once

#include "ViewGrid.h"

#include <QImage>

#include <filesystem>

namespace palpate
{
/// What a picture has where there is no slice, surface or text.
enum class PictureGround
{
  AsShown,
  White, ///< for print
  Transparent
};

/// A view at a size (pixels) of its own, larger or smaller than in the window. It shows at least
/// what the window's view shows; text and lines keep their size relative to the view, slices
/// have their titles, and the 3-D view looks as at rest. The view in the window is unchanged.
/// Colours are premultiplied by the opacity if the background is transparent; otherwise the picture
/// is opaque.
QImage PictureOf(ViewPane& pane, const QSize& size, PictureGround ground);

/// All four views, two by two, in a picture of this size.
QImage PictureOf(const ViewGrid& views, const QSize& size, PictureGround ground);

/// The window that the views are in, as it is on the screen.
QImage PictureOf(const ViewGrid& views, QWidget& window);

/// Writes a PNG file under AtomicFile's rules. Throws InputError.
void WritePicture(const QImage& picture, const std::filesystem::path& file);
} // namespace palpate

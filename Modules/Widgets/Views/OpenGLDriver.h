#pragma once

#include <QString>

namespace palpate
{
/// Name of the OpenGL driver of this machine (GL_RENDERER); empty if there is none. Takes some
/// milliseconds. Needs a QApplication.
QString OpenGLDriver();

/// Whether a driver of this name is a graphics card's, rather than Mesa's or Microsoft's software.
bool IsGraphicsCard(const QString& driver);
} // namespace palpate

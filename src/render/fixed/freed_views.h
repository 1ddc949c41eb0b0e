// Draws bitmaps and pixel rectangles without what makes Mesa crash.
#pragma once

namespace twinlight::fixed {

// Mesa frees the view of a texture too early if it draws
// - a bitmap with a texture, in 25.1 (25.1.7; not in 25.0.7 or 26.0.8);
// - a pixel rectangle with GL_MAP_COLOR, from 25.1 on (25.1.7, 26.0.8, 26.1.6; not 25.0.7): it keeps the tables as a texture.
// What uses the view later reads freed memory, and the program may crash. There the textures or GL_MAP_COLOR are off while this object
// exists; a display list that is compiled meanwhile turns them off and on, too. Elsewhere, and if the stack of attributes is full, it does
// nothing. golden/known_differences lists both: "a bitmap with a texture", "glPixelMap in pixel rectangles".
class KeepsViews {
  public:
    enum class Drawn { kBitmap, kPixels };
    explicit KeepsViews(Drawn drawn);
    ~KeepsViews();
    KeepsViews(const KeepsViews&) = delete;
    KeepsViews& operator=(const KeepsViews&) = delete;

  private:
    bool turns_off_;
};

}  // namespace twinlight::fixed

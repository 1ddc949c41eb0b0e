// Draws bitmaps without textures where textured ones make the driver crash.
#pragma once

namespace twinlight::fixed {

// Mesa 25.1 (25.1.7; not 25.0 or 26.0) frees the view of a texture too early if a bitmap is drawn with it: later draws with the texture
// read freed memory, and the program may crash. There all textures are off while this object exists; display lists that are compiled
// meanwhile turn them off and on, too. Elsewhere, and if the stack of attributes is full, it does nothing.
class UntexturedBitmap {
  public:
    UntexturedBitmap();
    ~UntexturedBitmap();
    UntexturedBitmap(const UntexturedBitmap&) = delete;
    UntexturedBitmap& operator=(const UntexturedBitmap&) = delete;

  private:
    bool turns_off_;
};

}  // namespace twinlight::fixed

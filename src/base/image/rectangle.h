// A rectangle of whole pixels: a viewport, a scissor box, a part of a picture or of the window.
#pragma once

namespace twinlight {

struct Rectangle {
    int x = 0, y = 0;  // the corner with the smallest coordinates; whether y goes up or down is for the user to say
    int width = 0, height = 0;

    bool contains(int px, int py) const { return px >= x && px < x + width && py >= y && py < y + height; }
    friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

}  // namespace twinlight

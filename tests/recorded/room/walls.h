void draw_walls();

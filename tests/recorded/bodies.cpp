// Classes and the standard library: the line is that of a virtual function.
#include <GL/glut.h>

#include <cstdlib>
#include <memory>
#include <vector>

struct Body {
    virtual ~Body() = default;
    virtual void material() const = 0;
    void draw() const {
        material();
        glutSolidSphere(0.4, 16, 12);
    }
};

struct Planet : Body {
    void material() const override {
        glMaterialf(GL_FRONT, GL_SHININESS, 20);  // warning: shininess-without-specular
    }
};

static std::vector<std::unique_ptr<Body>> bodies;

static void display() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (const auto& body : bodies) body->draw();
    glutSwapBuffers();
    std::exit(0);
}

int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH);
    glutInitWindowSize(64, 48);
    glutCreateWindow("bodies");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    bodies.push_back(std::make_unique<Planet>());
    glutDisplayFunc(display);
    glutMainLoop();
}

"""Robots: what a robot is made of, where its parts are, and how it moves, measures and fails.

model            what a URDF says: links, joints, shapes
xml_lines        XML that remembers its lines
urdf             a file -> a model, or an error that helps
kinematics       joint positions -> where every link is
"""
